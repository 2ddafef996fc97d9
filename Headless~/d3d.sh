# Microsoft's shader compilers under Wine, and vkd3d's, which turns Direct3D bytecode into SPIR-V: sets them up. To be sourced after lib.sh.
# They are kept in the user's cache, where the engine finds them too (Engine/Shaders/Direct3D/FxcTools.cs): what to run is the script
# $d3d/d3dcompile, with the arguments of D3d/d3dcompile.c.

d3d="${XDG_CACHE_HOME:-$HOME/.cache}/anatomycarve/d3d"
dlls_package=webgpu
dlls_version=0.6.2
dlls_sha256=77a6be6513b9f7c2e94425620ce603efb38cdc5d0393e1b31a1b0c8479330ffd

# Installs what is missing: Debian packages wine64, wine, gcc-mingw-w64-x86-64 and vkd3d-compiler (as root or through sudo), and the npm package
# webgpu 0.6.2, which carries the two DLLs.
ensure_d3d() {
    writable "$d3d" || fail "this keeps Microsoft's compilers in $d3d, and may not write there"
    exec 9> "$d3d/lock"
    flock 9 # two runs at once would trip over each other's set-up
    ensure_packages wine64 wine wine wine gcc-mingw-w64-x86-64 x86_64-w64-mingw32-gcc vkd3d-compiler vkd3d-compiler
    [[ -e "$d3d/d3dcompiler_47.dll" && -e "$d3d/dxcompiler.dll" ]] || fetch_dlls
    build_driver
    if [[ ! -e "$d3d/wine/system.reg" ]]; then
        say "preparing Wine (half a minute) ..."
        WINEPREFIX="$d3d/wine" WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml,winemenubuilder.exe=" must wineboot -i
    fi
    exec 9>&-
}

# must COMMAND ...: a step of the set-up.
must() { quietly 20 "$@" || fail "set-up failed: $*"; }

fetch_dlls() {
    local folder="$d3d/fetch"
    local archive="$folder/$dlls_package-$dlls_version.tgz"
    rm -rf "$folder"
    mkdir "$folder"
    say "fetching Microsoft's compilers (npm package $dlls_package $dlls_version, 51 MB) ..."
    if present npm; then
        must npm pack --silent --pack-destination "$folder" "$dlls_package@$dlls_version"
    else
        ensure_packages curl curl ca-certificates /etc/ssl/certs/ca-certificates.crt
        must curl -fsSL --retry 3 -o "$archive" "https://registry.npmjs.org/$dlls_package/-/$dlls_package-$dlls_version.tgz"
    fi
    echo "$dlls_sha256  $archive" | sha256sum --check --status || fail "the archive of $dlls_package $dlls_version is not the known one"
    must tar -xzf "$archive" -C "$folder" package/dist/win32-x64
    mv "$folder"/package/dist/win32-x64/{d3dcompiler_47,dxcompiler}.dll "$d3d/"
    rm -rf "$folder"
}

# The program is named after its source, so that checkouts of several versions do not take each other's.
build_driver() {
    local source="$headless/D3d/d3dcompile.c" program
    program="d3dcompile-$(sha256sum "$source" | cut -c 1-12).exe"
    if [[ ! -e "$d3d/$program" ]]; then
        must x86_64-w64-mingw32-gcc -O1 -Wall -Werror -Wno-unused-parameter -static -o "$d3d/$program.new" "$source"
        mv "$d3d/$program.new" "$d3d/$program"
    fi
    grep -sqF "$program" "$d3d/d3dcompile" && return
    # "n" = native: otherwise Wine's own d3dcompiler answers, which is not the one that Unity uses.
    cat > "$d3d/d3dcompile.new" << END
#!/bin/sh
# Written by Headless~/d3d.sh.
d3d="\$(dirname "\$0")"
export WINEPREFIX="\$d3d/wine" WINEDEBUG=-all WINEDLLOVERRIDES="d3dcompiler_47,dxcompiler=n;mscoree,mshtml,winemenubuilder.exe="
exec wine "\$d3d/$program" "\$@"
END
    chmod +x "$d3d/d3dcompile.new"
    mv "$d3d/d3dcompile.new" "$d3d/d3dcompile" # at once: another run may be using the old one
}
