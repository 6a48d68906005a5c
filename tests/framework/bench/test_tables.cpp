// SPDX-License-Identifier: Apache-2.0
// The tables of a bench against averages computed by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "framework/bench/cases.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/bench_tables.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::done;
using xgm::testing::empty_result;
using xgm::testing::failed;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A table of the Markdown page; the best of a column has a star.
struct Table {
  std::string title, header;
  std::vector<std::string> rows, notes;
};

std::string without_bars(const std::string& line) {
  static const std::regex best(R"(\*\*([^*]+)\*\*)"), bar(R"( *\| *)"), ends("^ | $");
  const std::string stars = std::regex_replace(line, best, "$1*");
  return std::regex_replace(std::regex_replace(stars, bar, " "), ends, "");
}

std::vector<Table> tables(const BenchResult& result) {
  std::vector<Table> found;
  for (const std::string& line : lines_of(bench_markdown(result))) {
    if (line.starts_with("## ")) found.push_back({line.substr(3), {}, {}, {}});
    if (line.starts_with("- ")) found.back().notes.push_back(line.substr(2));
    if (!line.starts_with("| ")) continue;
    Table& table = found.back();
    (table.header.empty() ? table.header : table.rows.emplace_back()) = without_bars(line);
  }
  return found;
}

/// Of the only set.
Table averages(const BenchResult& result) { return tables(result).at(0); }
Table scenes(const BenchResult& result) { return tables(result).at(1); }

/// Bars that separate cells; escaped ones do not.
std::size_t bars(const std::string& line) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\') {
      ++i;
    } else if (line[i] == '|') {
      ++count;
    }
  }
  return count;
}

/// Two pipelines on two scenes of which the second counts half.
BenchResult two_by_two() {
  BenchResult result = empty_result({"a", "b"}, {"one", "two"});
  result.request.scenes[1].files.weight = 0.5;
  result.cells = {done(0.10, 0.20, 1, 2), done(0.12, 0.16, 2, 1),   // scene one
                  done(0.40, 0.08, 4, 4), done(0.30, 0.10, 2, 3)};  // scene two
  return result;
}

}  // namespace

TEST_CASE("averages weigh the scenes, and total is invalid plus bad to the last bit") {
  const BenchResult result = two_by_two();
  const BenchAverage mean = average(result, 0, "set");
  CHECK(mean.scenes == 2);
  CHECK(mean.comparable);
  const Evaluation* evaluation = judged(mean.figures, result.rules);
  REQUIRE(evaluation != nullptr);
  // By hand: weights 1 and 1/2, sum 3/2.
  CHECK(evaluation->invalid == doctest::Approx((0.10 + 0.5 * 0.40) / 1.5));
  CHECK(evaluation->average_error == doctest::Approx((1 + 0.5 * 4) / 1.5));
  CHECK(evaluation->at[0].bad == doctest::Approx((0.20 + 0.5 * 0.08) / 1.5));
  CHECK(evaluation->at[0].total == evaluation->invalid + evaluation->at[0].bad);
  CHECK(mean.figures.seconds == doctest::Approx(3));  // seconds are not weighted
}

TEST_CASE("the table of averages has the paper's columns, and the best in each is marked") {
  const Table table = averages(two_by_two());
  CHECK(table.title == "set: weighted average of 2 scenes");
  CHECK(table.header == "pipeline scenes avg err invalid bad 1 total 1 s MB MDE/s");
  // a: 20 % invalid, 16 % bad; b: 18 % and 14 %. 50 million evaluations in 3 s and 2 s.
  CHECK(table.rows.at(0) == "a 2 2.00* 20.00 16.00 36.00 3.00 100* 16.7");
  CHECK(table.rows.at(1) == "b 2 2.00* 18.00* 14.00* 32.00* 2.00* 100* 25.0*");
}

TEST_CASE("figures that look the same share the first place, though their digits differ further") {
  BenchResult result = empty_result({"a", "b"}, {"one"});
  result.cells = {done(0.100001, 0.2, 1), done(0.100002, 0.2, 1.004)};
  const Table table = scenes(result);
  CHECK(table.rows.at(0) == "one a 1.00* 10.00* 20.00* 30.00* 1.00* 100* 50.0*");
  CHECK(table.rows.at(1) == "one b 1.00* 10.00* 20.00* 30.00* 1.00* 100* 50.0*");
}

TEST_CASE("each scene has its own best") {
  const Table table = scenes(two_by_two());
  CHECK(table.rows.at(0) == "one a 1.00* 10.00* 20.00 30.00 2.00 100* 25.0");
  CHECK(table.rows.at(1) == "one b 2.00 12.00 16.00* 28.00* 1.00* 100* 50.0*");
  CHECK(table.rows.at(2) == "two a 4.00 40.00 8.00* 48.00 4.00 100* 12.5");
  CHECK(table.rows.at(3) == "two b 2.00* 30.00* 10.00 40.00* 3.00* 100* 16.7*");
}

TEST_CASE("a failed cell is a marked row with the reason, and its pipeline is not ranked") {
  BenchResult result = two_by_two();
  result.cells[3] = failed("im1.png: is broken; copy it again");
  const Table table = averages(result);
  CHECK(table.rows.at(0) == "a 2 2.00 20.00 16.00 36.00 3.00 100 16.7");
  CHECK(table.rows.at(1) == "b 1 of 2 ! 2.00 12.00 16.00 28.00 1.00 100 50.0");
  REQUIRE(table.notes.size() == 2);
  CHECK(table.notes[0] == "! lacks scenes that others have: not comparable, and not ranked");
  CHECK(table.notes[1] == "b failed on two: im1.png: is broken; copy it again");
  CHECK(scenes(result).rows.at(3) == "two b failed – – – – – –");
  CHECK(result.failures() == 1);
}

TEST_CASE("pipelines that all lack the same scene remain comparable") {
  BenchResult result = two_by_two();
  result.cells[2] = result.cells[3] = failed("im1.png: is broken");
  const Table table = averages(result);
  CHECK(table.title == "set: average of 1 of 2 scenes");
  CHECK(table.rows.at(0) == "a 1 of 2 1.00* 10.00* 20.00 30.00 2.00 100* 25.0");
  CHECK(table.rows.at(1) == "b 1 of 2 2.00 12.00 16.00* 28.00* 1.00* 100* 50.0*");
}

TEST_CASE("what no pixel can tell is a dash, in the average too, and never the best") {
  BenchResult result = empty_result({"a", "b"}, {"one", "two"});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  result.cells = {done(1, 0, nan), done(0.5, 0.5, 9), done(0, 0, 1), done(0, 0, 1)};
  CHECK(scenes(result).rows.at(0) == "one a – 100.00 0.00* 100.00* 1.00* 100* 50.0*");
  CHECK(averages(result).rows.at(0) == "a 2 – 50.00 0.00* 50.00* 1.00* 100* 50.0*");
  CHECK(averages(result).rows.at(1) == "b 2 5.00* 25.00* 25.00 50.00* 1.00* 100* 50.0*");
}

TEST_CASE("scenes without truth have their costs and the share of pixels with a disparity") {
  BenchResult result = empty_result({"a"}, {"one", "two"});
  result.cells = {done(0.1, 0.2, 1), done(0.3, 0, 0)};
  result.cells[1].regions.clear();
  const Table by_scene = scenes(result);
  CHECK(contains(by_scene.header, " density "));
  CHECK(by_scene.rows.at(1) == "two a – – – – 70.00 1.00 100 50.0");
  const Table table = averages(result);
  CHECK(table.rows.at(0) == "a 2 1.00 10.00 20.00 30.00 80.00 1.00 100 50.0");
  REQUIRE(table.notes.size() == 1);
  CHECK(table.notes[0] == "no truth for: two");
}

TEST_CASE("the region asked for is the one judged") {
  BenchResult result = empty_result({"a"}, {"one"});
  result.cells = {done(0.1, 0.2, 1)};
  CHECK(judged(result.cells[0], {})->invalid == 0.1);
  CHECK(judged(result.cells[0], {.region = "all"})->invalid == 0.35);
  CHECK(judged(result.cells[0], {.region = "foreground"}) == nullptr);
  result.cells[0].regions.pop_back();  // a scene that does not tell hidden pixels apart
  CHECK(judged(result.cells[0], {})->invalid == 0.35);
  const Table table = averages(result);
  REQUIRE(table.notes.size() == 1);
  CHECK(table.notes[0] == "judged on hidden pixels too, as no mask tells them apart: one");
}

TEST_CASE("an interrupted bench says how much is missing") {
  BenchResult result = empty_result({"a", "b"}, {"one", "two"});
  result.cells[0] = done(0.1, 0.2, 1);
  result.interrupted = true;
  const Table table = averages(result);
  CHECK(table.rows.at(1) == "b 0 of 2 ! – – – – – – –");
  CHECK(table.notes.back() == "3 runs are still to be done");
  CHECK(contains(bench_markdown(result), "**Interrupted"));
}

TEST_CASE("sets are averaged each by itself") {
  BenchResult result = two_by_two();
  result.request.scenes[1].set = "other";
  CHECK(sets(result) == std::vector<std::string>{"set", "other"});
  CHECK(tables(result).at(1).rows.at(0) == "a 1 4.00 40.00 8.00* 48.00 4.00 100* 12.5");
}

TEST_CASE("Markdown tables have as many cells in each row, whatever the names hold") {
  BenchResult result = two_by_two();
  result.request.pipelines[0].name = "a|b*c";
  result.request.scenes[0].files.name = "<one>\n|";
  result.cells[3] = failed("it | broke\nbadly `here`");
  const std::string text = bench_markdown(result);
  std::size_t rows = 0, wanted = 0;
  for (const std::string& line : lines_of(text)) {
    if (!line.starts_with("|")) {
      wanted = 0;
      continue;
    }
    if (wanted == 0) wanted = bars(line);
    CHECK_MESSAGE(bars(line) == wanted, line);
    ++rows;
  }
  CHECK(rows == 2 + 2 + 2 + 4);  // heads, rules and rows of both tables
  CHECK(contains(text, "| b | 1 of 2 ! | 2.00 |"));
  CHECK(contains(text, "| **10.00** |"));
  CHECK(contains(text, "it \\| broke badly \\`here\\`"));
}

TEST_CASE("CSV has one line per average and cell, with as many fields as its head") {
  BenchResult result = two_by_two();
  result.cells[3] = failed("broken, \"really\"");
  const std::vector<std::string> lines = lines_of(bench_csv(result));
  REQUIRE(lines.size() == 1 + 2 + 4);
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) CHECK(commas(lines[i]) == commas(lines[0]));
  CHECK(lines[3].starts_with("scene,set,one,a,done,1,1,2,100000000,25,0.9,1000,1,"));
  CHECK(lines[6].ends_with("\"broken, \"\"really\"\"\""));
}

TEST_CASE("JSON holds averages, cells with all regions, and what failed") {
  BenchResult result = two_by_two();
  result.cells[3] = failed("broken");
  const auto json = nlohmann::json::parse(bench_json(result));
  CHECK(json["averages"].size() == 2);
  CHECK(json["averages"][1]["comparable"] == false);
  CHECK(json["cells"].size() == 4);
  CHECK(json["cells"][0]["truth"].size() == 2);
  CHECK(json["cells"][3]["failure"] == "broken");
  CHECK_FALSE(json["cells"][3].contains("seconds"));
}

TEST_CASE("HTML shows the tables with every name escaped") {
  BenchResult result = two_by_two();
  result.request.scenes[0].files.name = "<script>";
  const std::string page = bench_tables_html(result);
  CHECK_FALSE(contains(page, "<script>"));
  CHECK(contains(page, "&lt;script&gt;"));
  CHECK(contains(page, "<td><b>32.00</b></td>"));
}

TEST_CASE("terminal tables align, dashes included") {
  BenchResult result = two_by_two();
  result.cells[2] = result.cells[3] = failed("broken");
  result.cells[1].regions.clear();
  const std::vector<std::string> lines = lines_of(bench_text(result));
  const std::size_t end = lines[2].size();  // of the head
  CHECK(lines[2].ends_with("MDE/s"));
  CHECK(lines[3].size() == end);
  CHECK(lines[4].size() == end + 2 * 4);  // four dashes of three bytes
}

TEST_CASE("a line above the terminal's tables says what they are of") {
  BenchResult result = two_by_two();
  result.request.threads = 2;
  CHECK(lines_of(bench_text(result)).front() ==
        "shares in %, errors in px of the maps; judged: non-occluded pixels; 2 threads");
  result.rules = {.thresholds = {1}, .scale = 4, .clip = true, .region = "all"};
  CHECK(lines_of(bench_text(result)).front() ==
        "shares in %, errors in px of the maps times 4; judged: all pixels, clipped to the search "
        "range; 2 threads");
}

TEST_CASE("a figure that rounds to zero has no sign") {
  BenchResult result = empty_result({"a"}, {"one"});
  result.cells = {done(0, 0, -0.001)};
  CHECK(averages(result).rows.at(0) == "a 1 0.00 0.00 0.00 0.00 1.00 100 50.0");
}
