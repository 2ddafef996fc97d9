// Asks Microsoft's shader compilers whether they take a kernel or a stage. Runs under Wine; check-d3d builds and calls it.
//
//   d3dcompile.exe fxc FILE -E ENTRY -T cs_5_0|vs_5_0|ps_5_0 [-D NAME=VALUE]... [-Fo BYTECODE] [-Fc LISTING]
//   d3dcompile.exe dxc FILE -E ENTRY -T cs_6_0|vs_6_0|ps_6_0 [-D NAME=VALUE]...
//
// fxc: D3DCompile of d3dcompiler_47.dll, which Unity uses for Direct3D 11 and as the first step towards Vulkan and Metal.
// dxc: IDxcCompiler3 of dxcompiler.dll (DXIL only; its options are passed on as they are).
// The compiler's messages go to stderr. Exit code 0: compiled, perhaps with warnings; 1: refused; 2: bad usage or missing DLL.
#define COBJMACROS
#include <windows.h>
#include <d3dcompiler.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_MACROS 64
#define MAX_INCLUDES 256
#define PATH_LENGTH 1024

static char *readFile(const char *path, UINT *size)
{
    FILE *file = fopen(path, "rb");
    if (!file) return NULL;
    fseek(file, 0, SEEK_END);
    *size = (UINT)ftell(file);
    rewind(file);
    char *text = malloc(*size + 1);
    *size = (UINT)fread(text, 1, *size, file);
    text[*size] = 0;
    fclose(file);
    return text;
}

static void folderOf(const char *path, char *folder)
{
    snprintf(folder, PATH_LENGTH, "%s", path);
    char *slash = strrchr(folder, '/'), *backslash = strrchr(folder, '\\');
    char *last = slash > backslash ? slash : backslash;
    if (last) *last = 0; else strcpy(folder, ".");
}

// ---- FXC ----

// Files that were opened by #include, with the folder of each: an include is looked up beside the file that asks for it.
static struct { const void *text; char folder[PATH_LENGTH]; } opened[MAX_INCLUDES];
static int openedCount;
static char mainFolder[PATH_LENGTH];

static HRESULT WINAPI openInclude(ID3DInclude *self, D3D_INCLUDE_TYPE type, const char *name, const void *parent, const void **text, UINT *size)
{
    const char *folder = mainFolder;
    for (int i = 0; i < openedCount; i++)
        if (opened[i].text == parent) folder = opened[i].folder;
    char path[2 * PATH_LENGTH];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    *text = openedCount < MAX_INCLUDES ? readFile(path, size) : NULL;
    if (!*text) return E_FAIL;
    opened[openedCount].text = *text;
    folderOf(path, opened[openedCount++].folder);
    return S_OK;
}

static HRESULT WINAPI closeInclude(ID3DInclude *self, const void *text) { return S_OK; }

static int compileWithFxc(const char *path, int count, char **options)
{
    const char *entry = NULL, *target = NULL, *bytecode = NULL, *listing = NULL;
    D3D_SHADER_MACRO macros[MAX_MACROS + 1] = {{0}};
    int macroCount = 0;
    for (int i = 0; i + 1 < count; i += 2) {
        char *value = options[i + 1];
        if (!strcmp(options[i], "-E")) entry = value;
        else if (!strcmp(options[i], "-T")) target = value;
        else if (!strcmp(options[i], "-Fo")) bytecode = value;
        else if (!strcmp(options[i], "-Fc")) listing = value;
        else if (!strcmp(options[i], "-D") && macroCount < MAX_MACROS) {
            char *equals = strchr(value, '=');
            if (equals) *equals = 0;
            macros[macroCount].Name = value;
            macros[macroCount++].Definition = equals ? equals + 1 : "1";
        } else { fprintf(stderr, "unknown option %s\n", options[i]); return 2; }
    }
    UINT size;
    char *source = readFile(path, &size);
    HMODULE library = LoadLibraryA("d3dcompiler_47.dll");
    if (!source || !library || !entry || !target) { fprintf(stderr, "no source, library, entry or target: %s\n", path); return 2; }
    pD3DCompile compile = (pD3DCompile)(void *)GetProcAddress(library, "D3DCompile");
    pD3DDisassemble disassemble = (pD3DDisassemble)(void *)GetProcAddress(library, "D3DDisassemble");
    folderOf(path, mainFolder);
    ID3DIncludeVtbl vtable = {openInclude, closeInclude};
    ID3DInclude includer = {&vtable};
    ID3DBlob *code = NULL, *messages = NULL;
    // As Unity does for stages: they may use Direct3D 9's samplers and half numbers.
    UINT flags = D3DCOMPILE_OPTIMIZATION_LEVEL3 | (strncmp(target, "cs", 2) ? D3DCOMPILE_ENABLE_BACKWARDS_COMPATIBILITY : 0);
    HRESULT result = compile(source, size, path, macros, &includer, entry, target, flags, 0, &code, &messages);
    if (messages) fputs(ID3D10Blob_GetBufferPointer(messages), stderr);
    if (FAILED(result)) return 1;
    if (bytecode) {
        FILE *file = fopen(bytecode, "wb");
        size_t length = ID3D10Blob_GetBufferSize(code);
        if (!file || fwrite(ID3D10Blob_GetBufferPointer(code), 1, length, file) != length || fclose(file)) return 2;
    }
    if (listing) {
        ID3DBlob *text = NULL;
        FILE *file = fopen(listing, "wb");
        if (!file || FAILED(disassemble(ID3D10Blob_GetBufferPointer(code), ID3D10Blob_GetBufferSize(code), 0, NULL, &text))) return 2;
        fputs(ID3D10Blob_GetBufferPointer(text), file);
        fclose(file);
    }
    return 0;
}

// ---- DXC: dxcapi.h does not come with mingw, so the few entries of its vtables that are needed stand here ----

typedef struct DxcObject { void **vtable; } DxcObject;
typedef struct { const void *text; SIZE_T size; UINT encoding; } DxcSource;
typedef HRESULT(WINAPI *CreateInstance)(const GUID *type, const GUID *face, void **object);
typedef HRESULT(WINAPI *CreateIncludeHandler)(DxcObject *utils, DxcObject **handler);
typedef HRESULT(WINAPI *Compile)(DxcObject *compiler, const DxcSource *, WCHAR **arguments, UINT count, DxcObject *handler, const GUID *face, DxcObject **);
typedef HRESULT(WINAPI *GetStatus)(DxcObject *result, HRESULT *status);
typedef HRESULT(WINAPI *GetOutput)(DxcObject *result, int kind, const GUID *face, DxcObject **blob, void *name);
typedef const char *(WINAPI *GetStringPointer)(DxcObject *blob);

enum { UTILS_CREATE_INCLUDE_HANDLER = 9, COMPILER_COMPILE = 3, RESULT_GET_STATUS = 3, RESULT_GET_OUTPUT = 7, BLOB_GET_POINTER = 3 };
enum { OUTPUT_ERRORS = 2, UTF8 = 65001 };
static const GUID DxcCompilerClass = {0x73e22d93, 0xe6ce, 0x47f3, {0xb5, 0xbf, 0xf0, 0x66, 0x4f, 0x39, 0xc1, 0xb0}};
static const GUID DxcUtilsClass = {0x6245d6af, 0x66e0, 0x48fd, {0x80, 0xb4, 0x4d, 0x27, 0x17, 0x96, 0x74, 0x8c}};
static const GUID FaceDxcUtils = {0x4605c4cb, 0x2019, 0x492a, {0xad, 0xa4, 0x65, 0xf2, 0x0b, 0xb7, 0xd6, 0x7f}};
static const GUID FaceDxcCompiler3 = {0x228b4687, 0x5a6a, 0x4730, {0x90, 0x0c, 0x97, 0x02, 0xb2, 0x20, 0x3f, 0x54}};
static const GUID FaceDxcResult = {0x58346cda, 0xdde7, 0x4497, {0x94, 0x61, 0x6f, 0x87, 0xaf, 0x5e, 0x06, 0x59}};
static const GUID FaceDxcBlobUtf8 = {0x3da636c9, 0xba71, 0x4024, {0xa3, 0x01, 0x30, 0xcb, 0xf1, 0x25, 0x30, 0x5b}};

static int compileWithDxc(int count, char **options)
{
    WCHAR *arguments[2 * MAX_MACROS];
    UINT argumentCount = 0, size;
    for (int i = 0; i < count && argumentCount < 2 * MAX_MACROS; i++) {
        WCHAR *wide = malloc(PATH_LENGTH * sizeof(WCHAR));
        MultiByteToWideChar(CP_UTF8, 0, options[i], -1, wide, PATH_LENGTH);
        arguments[argumentCount++] = wide;
    }
    char *source = readFile(options[0], &size); // the file stands first; DXC takes it as the name for its messages and includes
    HMODULE library = LoadLibraryA("dxcompiler.dll");
    if (!source || !library) { fprintf(stderr, "no source or library: %s\n", options[0]); return 2; }
    CreateInstance create = (CreateInstance)(void *)GetProcAddress(library, "DxcCreateInstance");
    DxcObject *utils = NULL, *compiler = NULL, *includes = NULL, *result = NULL, *messages = NULL;
    if (FAILED(create(&DxcUtilsClass, &FaceDxcUtils, (void **)&utils))) return 2;
    if (FAILED(create(&DxcCompilerClass, &FaceDxcCompiler3, (void **)&compiler))) return 2;
    ((CreateIncludeHandler)utils->vtable[UTILS_CREATE_INCLUDE_HANDLER])(utils, &includes);
    DxcSource input = {source, size, UTF8};
    if (FAILED(((Compile)compiler->vtable[COMPILER_COMPILE])(compiler, &input, arguments, argumentCount, includes, &FaceDxcResult, &result))) return 2;
    HRESULT status = E_FAIL;
    ((GetStatus)result->vtable[RESULT_GET_STATUS])(result, &status);
    ((GetOutput)result->vtable[RESULT_GET_OUTPUT])(result, OUTPUT_ERRORS, &FaceDxcBlobUtf8, &messages, NULL);
    const char *text = messages ? ((GetStringPointer)messages->vtable[BLOB_GET_POINTER])(messages) : NULL; // NULL: nothing to say
    if (text) fputs(text, stderr);
    return FAILED(status) ? 1 : 0;
}

static int run(int count, char **arguments)
{
    if (count >= 3 && !strcmp(arguments[1], "fxc")) return compileWithFxc(arguments[2], count - 3, arguments + 3);
    if (count >= 3 && !strcmp(arguments[1], "dxc")) return compileWithDxc(count - 2, arguments + 2);
    fprintf(stderr, "usage: d3dcompile fxc|dxc FILE -E ENTRY -T TARGET [-D NAME=VALUE]...\n");
    return 2;
}

int main(int count, char **arguments)
{
    int code = run(count, arguments);
    fflush(NULL);
    // No return: when the compilers are unloaded, a thread now and then faults under Wine, and says so on stderr.
    TerminateProcess(GetCurrentProcess(), (UINT)code);
    return code;
}
