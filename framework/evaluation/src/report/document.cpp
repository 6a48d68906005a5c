// SPDX-License-Identifier: Apache-2.0
#include "report/document.hpp"

#include "report/assets.hpp"
#include "xgm/evaluation/report.hpp"
#include "xgm/plugin/version.hpp"

namespace xgm::report {
namespace {

// Scripts and pictures of the page itself, and nothing from anywhere else.
constexpr const char* kPolicy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

}  // namespace

std::string document(const std::string& title, const std::string& main,
                     const std::string& scripts) {
  return std::string("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n") +
         "<meta http-equiv=\"Content-Security-Policy\" content=\"" + kPolicy + "\">\n" +
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
         "<meta name=\"generator\" content=\"xgm " XGM_VERSION "\">\n<title>" + html_text(title) +
         "</title>\n<style>" + kStyle + "</style></head>\n<body><header>" + "<h1>" +
         html_text(title) + "</h1>" + "</header>\n<main>\n" + main +
         "</main>\n<footer>xgm " XGM_VERSION "</footer>\n" + scripts + "</body></html>\n";
}

}  // namespace xgm::report
