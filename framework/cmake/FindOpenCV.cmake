# SPDX-License-Identifier: Apache-2.0
# Finds single OpenCV modules as targets opencv_<component>. Distributions put OpenCV's own CMake file
# into a package that draws in every module and a desktop; this needs the modules' packages only, and
# each module may lie below another prefix.
find_package(OpenCV QUIET CONFIG COMPONENTS ${OpenCV_FIND_COMPONENTS})
if(OpenCV_FOUND)
  return()
endif()
set(required "")
foreach(component IN LISTS OpenCV_FIND_COMPONENTS)
  find_path(OpenCV_${component}_INCLUDE_DIR opencv2/${component}.hpp PATH_SUFFIXES opencv4)
  find_library(OpenCV_${component}_LIBRARY opencv_${component})
  mark_as_advanced(OpenCV_${component}_INCLUDE_DIR OpenCV_${component}_LIBRARY)
  list(APPEND required OpenCV_${component}_LIBRARY OpenCV_${component}_INCLUDE_DIR)
endforeach()
set(version_header ${OpenCV_core_INCLUDE_DIR}/opencv2/core/version.hpp)
if(EXISTS ${version_header})
  file(STRINGS ${version_header} lines REGEX "#define CV_VERSION_(MAJOR|MINOR|REVISION) ")
  string(REGEX REPLACE "[^0-9]+([0-9]+)[^0-9]*([0-9]+)[^0-9]*([0-9]+).*" "\\1.\\2.\\3"
    OpenCV_VERSION "${lines}")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCV REQUIRED_VARS ${required} VERSION_VAR OpenCV_VERSION)
if(OpenCV_FOUND)
  foreach(component IN LISTS OpenCV_FIND_COMPONENTS)
    if(NOT TARGET opencv_${component})
      add_library(opencv_${component} UNKNOWN IMPORTED)
      set_target_properties(opencv_${component} PROPERTIES
        IMPORTED_LOCATION ${OpenCV_${component}_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES ${OpenCV_${component}_INCLUDE_DIR})
    endif()
  endforeach()
endif()
