# What the commands of Headless~ share: where things are, what they need from the system, how they build. To be sourced by bash.

headless="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
repo="$(dirname "$headless")"
artifacts="$headless/artifacts"

export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_CLI_WORKLOAD_UPDATE_NOTIFY_DISABLE=1

say() { printf '%s\n' "$*" >&2; }

fail() {
    say "$(basename "$0"): $*"
    exit 1
}

# writable FOLDER: makes a folder if need be; whether files can be made in it.
writable() { mkdir -p "$1" 2> /dev/null && [[ -w "$1" ]]; }

writable "$artifacts" && writable "$headless/out" || fail "this writes below $headless, and may not"
# .NET, Wine and the engine keep their caches at home. A service or a container may have none.
writable "${HOME:-}" || { export HOME="$artifacts/home"; writable "$HOME"; }

# quietly LINES COMMAND ...: runs a command; the last LINES lines of what it says are shown only if it fails.
quietly() {
    local log code=0
    log="$(mktemp)" || fail "there is no writable folder for temporary files"
    "${@:2}" > "$log" 2>&1 || code=$?
    ((code == 0)) || tail -n "$1" "$log" >&2
    rm -f "$log"
    return "$code"
}

# present THING: whether the system has it. A path (may hold wildcards), "lib:NAME" for a shared library, otherwise a command.
present() {
    case "$1" in
        lib:*) { ldconfig -p 2> /dev/null || /sbin/ldconfig -p; } | grep -F "${1#lib:}" > /dev/null ;;
        /*) compgen -G "$1" > /dev/null ;;
        *) command -v "$1" > /dev/null ;;
    esac
}

# ensure_packages PACKAGE THING [PACKAGE THING ...]: installs the Debian packages whose thing is absent, as root or through sudo.
# A package whose name holds its version is given as the regular expression that apt-get takes: ^name[0-9]+$.
ensure_packages() {
    local missing=() things=()
    while (($# > 0)); do
        present "$2" || { missing+=("$1"); things+=("${2#lib:}"); }
        shift 2
    done
    ((${#missing[@]} > 0)) || return 0

    local as_root=()
    command -v apt-get > /dev/null \
        || fail "this needs ${things[*]}, on Debian the packages ${missing[*]}; there is no apt-get here, please install them by hand"
    if ((EUID != 0)); then
        command -v sudo > /dev/null && { sudo -n true 2> /dev/null || [[ -t 0 ]]; } \
            || fail "this needs ${things[*]} and may not install it; please run, as root: apt-get install ${missing[*]@Q}"
        as_root=(sudo)
    fi

    local names=("${missing[@]#^}")
    say "installing ${names[*]%%[*} ..."
    # A fresh system has no package lists. Where only some other source is out of reach, what is needed may still be found: no reason to end.
    if [[ "$lists_are_new" == no ]]; then
        quietly 5 "${as_root[@]}" apt-get update -qq || say "apt-get update failed; trying with the lists that there are"
        lists_are_new=yes
    fi
    quietly 5 "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get -o DPkg::Lock::Timeout=300 install -y -qq --no-install-recommends "${missing[@]}" \
        || fail "could not install ${missing[*]}; please run, as root: apt-get install ${missing[*]@Q}"
}

lists_are_new=no

# What the engine needs to compile shaders and to run them, on a GPU or on Mesa's driver for the CPU.
ensure_vulkan() {
    ensure_packages \
        libvulkan1 lib:libvulkan.so.1 \
        mesa-vulkan-drivers '/usr/share/vulkan/icd.d/lvp_icd*.json' \
        glslang-tools glslangValidator
}

# What .NET needs to build: itself, and what it takes to fetch packages over TLS.
ensure_dotnet() {
    command -v dotnet > /dev/null || fail "the .NET SDK 10 is missing; https://dotnet.microsoft.com/download says how to install it"
    dotnet --list-sdks | grep -E '^(1[0-9]|[2-9][0-9])\.' > /dev/null || fail "the .NET SDK 10 or newer is needed; this is $(dotnet --version)"
    ensure_packages '^libssl[0-9.]+(t64)?$' lib:libssl.so ca-certificates /etc/ssl/certs/ca-certificates.crt
}

# .NET takes its cultures from ICU.
ensure_cultures() {
    ensure_packages '^libicu[0-9]+$' lib:libicuuc.so
}

# The same for what does not depend on cultures: it goes on without them.
prefer_cultures() {
    (ensure_cultures) || {
        say "going on without it"
        export DOTNET_SYSTEM_GLOBALIZATION_INVARIANT=1
    }
}

# build PROJECT [ARGUMENT ...]: builds a project of Headless~ in Release; what the compiler says is shown only if it fails.
build() {
    quietly 200 dotnet build "$headless/$1" --configuration Release --verbosity quiet -nologo "${@:2}" || fail "building $1 failed"
}

# build_if_changed PROJECT: the same, but only if a source is newer than the last time. Starting dotnet to find that out takes seconds.
build_if_changed() {
    local stamp="$artifacts/built-${1//\//-}"
    if [[ -e "$stamp" ]] && [[ -z "$(find "$headless" "$repo/Runtime" "$repo/Editor" -path "$artifacts" -prune -o -path "$headless/out" -prune \
        -o \( -name '*.cs' -o -name '*.csproj' -o -name '*.props' -o -name '*.targets' -o -path '*/ShaderLibrary/*' -o -type d \) -newer "$stamp" -print -quit)" ]]; then
        return
    fi
    say "building ..."
    local begun
    mkdir -p "$artifacts"
    begun="$(mktemp "$artifacts/building.XXXXXX")"
    build "$1"
    mv "$begun" "$stamp"
}

# run_built PROJECT/ASSEMBLY [ARGUMENT ...]: runs what was built.
run_built() {
    dotnet "$artifacts/bin/$(dirname "$1")/release/$(basename "$1").dll" "${@:2}"
}
