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

# present THING: whether the system has it. A path (may hold wildcards), "lib:NAME" for a shared library, otherwise a command.
present() {
    case "$1" in
        lib:*) { ldconfig -p 2> /dev/null || /sbin/ldconfig -p; } | grep -F "${1#lib:}" > /dev/null ;;
        /*) compgen -G "$1" > /dev/null ;;
        *) command -v "$1" > /dev/null ;;
    esac
}

# ensure_packages PACKAGE THING [PACKAGE THING ...]: installs the Debian packages whose thing is absent, as root or through sudo.
ensure_packages() {
    local missing=() things=()
    while (($# > 0)); do
        present "$2" || { missing+=("$1"); things+=("$2"); }
        shift 2
    done
    ((${#missing[@]} > 0)) || return 0

    local as_root=()
    command -v apt-get > /dev/null \
        || fail "this needs ${things[*]}, on Debian the packages ${missing[*]}; there is no apt-get here, please install them by hand"
    if ((EUID != 0)); then
        command -v sudo > /dev/null && sudo -n true 2> /dev/null || [[ -t 0 && -n "$(command -v sudo)" ]] \
            || fail "this needs the packages ${missing[*]} and may not install them; please run: apt-get install ${missing[*]}"
        as_root=(sudo)
    fi

    say "installing ${missing[*]} ..."
    local log
    log="$(mktemp)"
    if ! { "${as_root[@]}" apt-get update -qq \
        && "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"; } > "$log" 2>&1; then
        tail -n 5 "$log" >&2
        rm -f "$log"
        fail "could not install ${missing[*]}; please run: apt-get install ${missing[*]}"
    fi
    rm -f "$log"
}

# What the engine needs to compile shaders and to run them, on a GPU or on Mesa's driver for the CPU.
ensure_vulkan() {
    ensure_packages \
        libvulkan1 lib:libvulkan.so.1 \
        mesa-vulkan-drivers '/usr/share/vulkan/icd.d/lvp_icd*.json' \
        glslang-tools glslangValidator
}

ensure_dotnet() {
    command -v dotnet > /dev/null || fail "the .NET SDK 10 is missing; https://dotnet.microsoft.com/download says how to install it"
    dotnet --list-sdks | grep -E '^(1[0-9]|[2-9][0-9])\.' > /dev/null || fail "the .NET SDK 10 or newer is needed; this is $(dotnet --version)"
    # .NET wants ICU for cultures; Debian names the package after its version.
    if ! present lib:libicuuc.so; then
        local icu
        icu="$(apt-cache search --names-only '^libicu[0-9]+$' 2> /dev/null | awk '{ print $1 }' | sort -V | tail -n 1)"
        [[ -n "$icu" ]] && (ensure_packages "$icu" lib:libicuuc.so) || export DOTNET_SYSTEM_GLOBALIZATION_INVARIANT=1
    fi
}

# build PROJECT [ARGUMENT ...]: builds a project of Headless~ in Release; what the compiler says is shown only if it fails.
build() {
    local log
    log="$(mktemp)"
    if ! dotnet build "$headless/$1" --configuration Release --verbosity quiet -nologo "${@:2}" > "$log" 2>&1; then
        cat "$log" >&2
        rm -f "$log"
        fail "building $1 failed"
    fi
    rm -f "$log"
}

# build_if_changed PROJECT: the same, but only if a source is newer than the last time. Starting dotnet to find that out takes seconds.
build_if_changed() {
    local stamp="$artifacts/built-${1//\//-}"
    if [[ -e "$stamp" ]] && [[ -z "$(find "$headless" "$repo/Runtime" -path "$artifacts" -prune -o -path "$headless/out" -prune \
        -o \( -name '*.cs' -o -name '*.csproj' -o -name '*.props' -o -name '*.targets' -o -type d \) -newer "$stamp" -print -quit)" ]]; then
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
