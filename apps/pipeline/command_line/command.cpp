// SPDX-License-Identifier: Apache-2.0
#include "command_line/command.hpp"

#include <CLI/CLI.hpp>

namespace xgm::cli {
namespace {

/// The check without its note in the help, where the type's name says FILE already.
Option check(CLI::Option* option, const CLI::Validator& validator) {
  return Option(option->check(CLI::Validator(validator).description("")));
}

}  // namespace

Option Option::type_name(const std::string& name) { return Option(option_->type_name(name)); }
Option Option::required() { return Option(option_->required()); }
Option Option::needs(Option other) { return Option(option_->needs(other.option_)); }
Option Option::excludes(Option other) { return Option(option_->excludes(other.option_)); }

Option Option::existing_file() { return check(option_, CLI::ExistingFile); }
Option Option::existing_path() { return check(option_, CLI::ExistingPath); }
Option Option::range(int min, int max) { return Option(option_->check(CLI::Range(min, max))); }
Option Option::one_of(const std::vector<std::string>& values) {
  return Option(option_->check(CLI::IsMember(values)));
}
Option Option::one_of(const std::vector<int>& values) {
  return Option(option_->check(CLI::IsMember(values)));
}

Option Option::count(int min, int max) { return Option(option_->expected(min, max)); }
Option Option::value_of_name_alone(const std::string& value) {
  return Option(option_->expected(0, 1)->default_str(value));
}
Option Option::one_value_each() { return Option(option_->allow_extra_args(false)); }
Option Option::comma_separated() {
  const auto trim = [](std::string item) { return CLI::detail::trim(item); };
  return Option(option_->delimiter(',')->transform(trim));
}

Option Option::show_default() { return Option(option_->capture_default_str()); }
Option Option::show_default(const std::string& text) { return Option(option_->default_str(text)); }

Option Command::option(const std::string& names, std::string& value, const std::string& help) {
  return Option(app_->add_option(names, value, help));
}
Option Command::option(const std::string& names, std::vector<std::string>& value,
                       const std::string& help) {
  return Option(app_->add_option(names, value, help));
}
Option Command::option(const std::string& names, int& value, const std::string& help) {
  return Option(app_->add_option(names, value, help));
}
Option Command::option(const std::string& names, std::uint64_t& value, const std::string& help) {
  return Option(app_->add_option(names, value, help));
}
Option Command::option(const std::string& names, double& value, const std::string& help) {
  return Option(app_->add_option(names, value, help));
}
Option Command::option(const std::string& names, std::optional<double>& value,
                       const std::string& help) {
  return Option(app_->add_option(names, value, help));
}
Option Command::flag(const std::string& name, bool& value, const std::string& help) {
  return Option(app_->add_flag(name, value, help));
}

Option Command::find(const std::string& name) const { return Option(app_->get_option(name)); }
void Command::footer(const std::string& text) { app_->footer(text); }

}  // namespace xgm::cli
