#!/usr/bin/env bash
cd /work/main
cmake --preset release -DCROQUIS_WARNINGS_AS_ERRORS=ON -DCROQUIS_BUILD_TESTS=ON >/dev/null && exec ninja -C build/release "$@"
