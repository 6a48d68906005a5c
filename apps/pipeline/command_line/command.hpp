// SPDX-License-Identifier: Apache-2.0
// What commands say of their options. CLI11, which parses them, takes seconds to compile: only the
// sources of this folder see it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace xgm::cli {

/// An option, or an argument that has a place in place of a name.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  /// How its value is called in the help.
  Option type_name(const std::string& name);
  Option required();
  Option needs(Option other);
  Option excludes(Option other);

  Option existing_file();
  Option existing_path();
  Option range(int min, int max);
  Option one_of(const std::vector<std::string>& values);
  Option one_of(const std::vector<int>& values);

  /// Takes so many values in a row.
  Option count(int min, int max);
  /// May be given by its name alone, and has this value then.
  Option value_of_name_alone(const std::string& value);
  /// Of one value; the option may be given again.
  Option one_value_each();
  Option comma_separated();

  /// The present value of its variable, in the help.
  Option show_default();
  Option show_default(const std::string& text);

 private:
  CLI::Option* option_;
};

/// A subcommand whose options are being added; their variables get the values.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}

  /// `names`: "-o,--output", or "scene" for an argument without dashes.
  Option option(const std::string& names, std::string& value, const std::string& help);
  Option option(const std::string& names, std::vector<std::string>& value, const std::string& help);
  Option option(const std::string& names, int& value, const std::string& help);
  Option option(const std::string& names, std::uint64_t& value, const std::string& help);
  Option option(const std::string& names, double& value, const std::string& help);
  Option option(const std::string& names, std::optional<double>& value, const std::string& help);
  Option flag(const std::string& name, bool& value, const std::string& help);

  /// One that was added before.
  Option find(const std::string& name) const;
  /// What the help says at its end.
  void footer(const std::string& text);

 private:
  CLI::App* app_;
};

}  // namespace xgm::cli
