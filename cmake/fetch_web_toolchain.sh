#!/bin/sh
# Fetches what makes a page of the program into FOLDER, from Debian 13 ("trixie"): emscripten and its binaryen, as they are
# packaged, and the sources of zlib and libpng, which the page brings along.
#
#   cmake/fetch_web_toolchain.sh FOLDER     leaves FOLDER/web, which cmake/web.cmake takes
#
# Why not install packages: Debian 12's emscripten knows no C++20, and Debian 13's comes with 1.7 GB, of which a page needs
# a tenth. Clang is Debian's own in both. Where binaryen wants a newer C library than the system has, it gets that one.
set -eu

. "$(dirname "$0")/private_apt.sh"
begin web "$1" web/complete
private apt-get download emscripten binaryen node-acorn libc6 libgcc-s1 libstdc++6 ||
    die "emscripten's packages could not be fetched"

# ---- Packages, as they would lie under /. Left out: link-time optimisation, threads, shared libraries, what only helps to
# ---- find mistakes, and emscripten's own tests.

root=$work/web/root
mkdir -p "$root"
for package in emscripten binaryen node-acorn libc6 libgcc-s1 libstdc++6; do
    dpkg-deb --fsys-tarfile ${package}_*.deb | tar -x -C "$root" --no-same-owner \
        --exclude='*/wasm32-emscripten/lto*' --exclude='*/wasm32-emscripten/pic' --exclude='*/wasm64-emscripten' \
        --exclude='*-mt*.a' --exclude='*-ww*.a' --exclude='*-asan*.a' --exclude='*-debug*.a' --exclude='*_rt*.a' \
        --exclude='libwasmfs*' --exclude='./usr/share/emscripten/test*' --exclude='./usr/share/doc' \
        --exclude='./usr/share/man' --exclude='./usr/share/locale' --exclude='*/gconv' ||
        die "$package could not be unpacked"
done
em=$root/usr/share/emscripten

# ---- What emscripten runs

for tool in clang-19 wasm-ld-19 llvm-ar-19 node; do
    command -v $tool >/dev/null || die "$tool is missing: install clang-19, lld-19, llvm-19 and nodejs"
done
mkdir -p web/binaryen/bin
loader=$(cd "$root" && find . -name 'ld-linux-*.so.*' | sort | tail -1)
libraries=$(cd "$root" && dirname "$(find . -name libstdc++.so.6)")
for tool in "$root"/usr/bin/wasm-*; do
    cat >"web/binaryen/bin/${tool##*/}" <<EOF
#!/bin/sh
root=\$(cd "\$(dirname "\$0")/../../root" && pwd)
exec "\$root/$loader" --library-path "\$root/$libraries" "\$root/usr/bin/${tool##*/}" "\$@"
EOF
done
chmod +x web/binaryen/bin/*
ln -s ../nodejs "$em/node_modules"  # its tools are ES modules, for which NODE_PATH does nothing
cat >"$em/.emscripten" <<EOF
LLVM_ROOT = '$(dirname "$(command -v clang-19)")'
LLVM_ADD_VERSION = CLANG_ADD_VERSION = '19'
BINARYEN_ROOT = '$folder/web/binaryen'
NODE_JS = '$(command -v node)'
CACHE = '$folder/web/root/usr/share/emscripten/cache'
FROZEN_CACHE = False
EOF

# ---- The libraries that a page brings along

for package in zlib libpng1.6; do
    source_of $package "web/$package" || die "$package's source could not be fetched"
done

touch web/complete
finish web
