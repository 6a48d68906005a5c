# SPDX-License-Identifier: Apache-2.0
# The first commands on a fresh machine. All else is CMake: see CMakePresets.json.
# CMAKE_FLAGS is handed to CMake:  make test CMAKE_FLAGS=-DXGM_WARNINGS_AS_ERRORS=ON

aloe := build/aloe
demo := build/demo
pipeline := build/release/bin/pipeline

.DELETE_ON_ERROR:
.PHONY: help packages configure build python deb demo test check reference format
help:
	@echo "make demo    match the Aloe pair with the paper's best pipeline; pictures in $(demo)/"
	@echo "make build   the program, $(pipeline), and the SDK"
	@echo "make python  the Python package, in build/release/python"
	@echo "make deb     Debian packages of program, SDK and Python package, in build/package"
	@echo "make test    build and run the whole test suite"
	@echo "make check   what every change must pass: .ci/run"
	@echo "make reference  write docs/reference anew, after plugins changed"
	@echo "make format  lay out all sources as the format check wants them"
	@echo "Missing Debian packages are installed first (as root or with sudo)."

packages:
	@.ci/packages build

configure: packages
	@cmake --preset release $(CMAKE_FLAGS) >build/configure.log || { cat build/configure.log; exit 1; }

# All that can be installed.
build: configure
	@cmake --build --preset release --target pipeline xgm_testing

python:
	@.ci/packages build python
	@cmake --preset release -DXGM_BUILD_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3 $(CMAKE_FLAGS) \
	  >build/configure.log || { cat build/configure.log; exit 1; }
	@cmake --build --preset release --target xgm_python

# One after the other: both configure the same folder.
deb:
	@$(MAKE) --no-print-directory build
	@$(MAKE) --no-print-directory python
	@.ci/packages build deb
	@cpack --config build/release/CPackConfig.cmake -G DEB -B build/package

demo: build $(aloe)/aloeGT.png
	@$(pipeline) run tmgm16_refined.yaml --left $(aloe)/aloeL.jpg --right $(aloe)/aloeR.jpg \
	  --disparities 0:224 --truth $(aloe)/aloeGT.png --truth-divisor 1 --report \
	  --output $(demo)

# A photographed pair with measured disparities (Middlebury 2006), as Debian ships it.
$(aloe)/aloeGT.png:
	@echo "Getting the Aloe pair out of Debian's package opencv-doc (96 MB)"
	@.ci/unpack opencv-doc $(aloe) --strip-components=7 --touch '*/aloe*'

test: configure
	@cmake --build --preset release
	@ctest --preset release

check:
	@.ci/run

reference: configure
	@cmake --build --preset release --target xgm_docs_tests
	@build/release/bin/xgm_docs_tests --no-skip --test-case="write docs/reference"

format:
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format-14 -i
