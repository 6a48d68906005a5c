// SPDX-License-Identifier: Apache-2.0
// Rules about the text of single files notice planted violations, and nothing else.
#include <doctest/doctest.h>

#include "architecture/rules.hpp"
#include "architecture/told.hpp"

using namespace xgm::architecture;

namespace {

std::string lines(int count, const std::string& line) {
  std::string text;
  for (int i = 0; i < count; ++i) text += line + "\n";
  return text;
}

Violations long_functions_in(const std::string& text) { return long_functions({{"a.cpp", text}}); }

}  // namespace

TEST_CASE("architecture rules: a missing licence is seen") {
  CHECK(missing_licences({{"a.cpp", "// Copyright someone\n"}}).size() == 1);
  CHECK(missing_licences({{"a.cpp", ""}}).size() == 1);
  CHECK(missing_licences({{"a.cmake", "# SPDX-License-Identifier: Apache-2.0\n"}}) == Violations{});
}

TEST_CASE("architecture rules: a file of more than 400 lines is seen") {
  CHECK(long_files({{"a.cpp", lines(401, "")}}).size() == 1);
  CHECK(long_files({{"a.cpp", lines(400, "")}}) == Violations{});
}

TEST_CASE("architecture rules: a function of more than 60 lines is seen wherever it stands") {
  const std::string in_function = lines(59, "  work();"), in_method = lines(59, "    work();");
  CHECK(long_functions_in("int f(int a) {\n" + in_function + "}\n") ==
        Violations{"a.cpp:1: 'int f(int a) {' has 61 lines"});
  CHECK(long_functions_in("int f(int a,\n      int b) {  // sum\n" + in_function + "}\n").size() ==
        1);
  CHECK(long_functions_in("template <class T>\nT f(T a) {\n" + in_function + "}\n").size() == 1);
  CHECK(long_functions_in("TEST_CASE(\"a\") {\n" + in_function + "}\n").size() == 1);
  CHECK(long_functions_in("int main() try {\n" + in_function + "} catch (...) {\n}\n").size() == 1);
  CHECK(long_functions_in("A::A(int a)\n    : a_(a),\n      b_{a} {\n" + in_function + "}\n")
            .size() == 1);
  CHECK(
      long_functions_in("namespace a {\nclass B final : public C {\n public:\n  int f() const {\n" +
                        in_method + "  }\n};\n}  // namespace a\n")
          .size() == 1);
  CHECK(long_functions_in("int f() {\n  call([&](int y) {\n" + in_method + "  });\n}\n").size() ==
        1);
}

TEST_CASE("architecture rules: what is no function, and 60 lines, are no violation") {
  const std::string short_body = lines(58, "  work();");
  for (const std::string& text :
       {"int f() {\n" + short_body + "}\n",
        "int f() {\n" + short_body + "}\n\nint g() {\n" + short_body + "}\n",
        "namespace a {\n" + lines(100, "int f();") + "}  // namespace a\n",
        "class A : public B<void()> {\n public:\n" + lines(100, "  int f();") + "};\n",
        "enum class A {\n" + lines(100, "  a,") + "};\n",
        "const std::vector<A> kAll{\n" + lines(100, "    f(1),") + "};\n",
        "const auto kAll = make({\n" + lines(100, "    f(1),") + "});\n",
        "struct A {\n" + lines(100, "  int a = f();") + "};\n",
        lines(100, "int f() { return 1; }")})
    CHECK(told(long_functions_in(text)) == "");
}

TEST_CASE("architecture rules: a matrix without a type of elements is seen in public headers") {
  const std::string header = "framework/core/include/xgm/data/a.hpp";
  CHECK(untyped_matrices({{header, "\nvoid f(const cv::Mat& a);\n"}}) ==
        Violations{header + ":2 has a cv::Mat without a type of elements"});
  CHECK(untyped_matrices({{header, "cv::Mat1f a;  // not a cv::Mat\ncv::Mat_<int> b;\n"}}) ==
        Violations{});
  CHECK(untyped_matrices({{"framework/core/src/data/a.cpp", "cv::Mat a;\n"}}) == Violations{});
}
