# SPDX-License-Identifier: Apache-2.0
# Builds the style, the viewer and the program of the report's page into the library, so that it
# looks for no file when it runs. A changed file configures anew.
set(page_folder ${CMAKE_CURRENT_SOURCE_DIR}/src/report/page)

# The files of a pattern, in the order of their names, one after the other.
function(xgm_read_page variable pattern)
  file(GLOB files CONFIGURE_DEPENDS ${page_folder}/${pattern})
  list(SORT files)
  set(all "")
  foreach(file IN LISTS files)
    file(READ ${file} text)
    string(APPEND all "${text}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endforeach()
  set(${variable} "${all}" PARENT_SCOPE)
endfunction()

xgm_read_page(XGM_PAGE_STYLE *.css)
xgm_read_page(XGM_PAGE_VIEWER viewer.html)
xgm_read_page(XGM_PAGE_PROGRAM *.js)
configure_file(${CMAKE_CURRENT_SOURCE_DIR}/src/report/assets.cpp.in
  ${PROJECT_BINARY_DIR}/generated/report_assets.cpp @ONLY)
