# SPDX-License-Identifier: Apache-2.0
# cmake -DFOLDER=<build folder> -P one_manifest.cmake
# Installing by components leaves a list of files of each; who builds a wheel reads one list.
file(GLOB lists ${FOLDER}/install_manifest_*.txt)
set(all "")
foreach(list IN LISTS lists)
  file(STRINGS ${list} files)
  list(APPEND all ${files})
endforeach()
list(JOIN all "\n" text)
file(WRITE ${FOLDER}/install_manifest.txt "${text}\n")
file(REMOVE ${lists})
