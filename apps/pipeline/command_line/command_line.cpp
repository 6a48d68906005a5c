// SPDX-License-Identifier: Apache-2.0
#include "command_line/command_line.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "terminal/console.hpp"
#include "xgm/base/error.hpp"
#include "xgm/pipeline/lookup.hpp"
#include "xgm/plugin/version.hpp"

namespace xgm::cli {
namespace {

/// Names with their dashes.
std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// "-o" of "-oDIR", "--set" of "--set=a=1"; empty if this is a value, such as -64:64.
std::string option_name(const std::string& argument) {
  if (argument.starts_with("--")) return argument.substr(0, argument.find('='));
  const bool is_short = argument.size() > 1 && argument[0] == '-' &&
                        std::isalpha(static_cast<unsigned char>(argument[1])) != 0;
  return is_short ? argument.substr(0, 2) : "";
}

void require_option(const std::string& argument, const std::vector<std::string>& known) {
  const std::string name = option_name(argument);
  if (name.empty() || std::ranges::find(known, name) != known.end()) return;
  const std::string with_two_dashes = "-" + argument.substr(0, argument.find('='));
  if (std::ranges::find(known, with_two_dashes) != known.end()) {
    throw UsageError("there is no option '" + argument + "'; did you mean '" + with_two_dashes +
                     "'?");
  }
  require_name("option", name, known);
}

bool looks_like_image(const std::string& argument) {
  static constexpr std::array kEndings{".png", ".jpg", ".jpeg", ".tif", ".tiff",
                                       ".pgm", ".ppm", ".bmp",  ".webp"};
  std::string ending = std::filesystem::path(argument).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

/// Whether all that follows up to the next option belongs to it.
bool takes_list(const CLI::App& command, const std::string& name) {
  const CLI::Option* const option = command.get_option_no_throw(name);
  return option != nullptr && option->get_allow_extra_args();
}

/// Many call a matcher with two images, without the names of options.
void require_named_images(const std::vector<std::string>& arguments, const CLI::App& command) {
  if (command.get_option_no_throw("--left") == nullptr) return;
  std::string before;  // the last option, as long as what follows may be its value
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const std::string name = option_name(argument);
    if (!name.empty()) {
      before = name;
      continue;
    }
    const bool has_place = before.empty();
    if (!takes_list(command, before)) before.clear();
    if (has_place && looks_like_image(argument) && !std::filesystem::is_directory(argument)) {
      const bool of_satellites = command.get_option_no_throw("--images") != nullptr;
      throw UsageError("'" + argument + "' is an image: give images as --left FILE --right FILE" +
                       (of_satellites ? ", those of satellites as --images FILE FILE" : ""));
    }
  }
}

/// What stands behind no option, and behind those that take one value.
std::string taken_for_scene(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    const CLI::Option* const scene = command->get_option_no_throw("scene");
    if (scene == nullptr || scene->count() == 0) continue;
    return "; '" + scene->results().front() + "' is taken for the scene";
  }
  return {};
}

/// --help and the like, which stand before a subcommand, or in place of it.
void require_option_without_subcommand(const std::string& argument, const CLI::App& command) {
  const std::vector<std::string> known = option_names(command);
  if (std::ranges::find(known, argument) != known.end()) return;
  throw UsageError("the subcommand comes first, its options behind it: pipeline run " + argument +
                   " ...; see pipeline --help");
}

}  // namespace

CommandLine::CommandLine(int argc, char** argv)
    : arguments_(argv + 1, argv + argc),
      app_(std::make_unique<CLI::App>("Dense stereo matching by pipelines of plugins.",
                                      "pipeline")) {
  app_->set_version_flag("--version", "xgm " XGM_VERSION);
  app_->require_subcommand(1);
  app_->footer(
      "Exit codes: 0 done; 1 the run failed or its map is empty; 2 usage or configuration.");
}

CommandLine::~CommandLine() = default;

void CommandLine::add_group(const std::string& name, const std::string& help) {
  app_->add_subcommand(name, help)->require_subcommand(1);
}

Command CommandLine::add(const std::string& name, const std::string& help,
                         std::function<int()> body) {
  const std::size_t blank = name.find(' ');
  CLI::App* const group =
      blank == std::string::npos ? app_.get() : app_->get_subcommand(name.substr(0, blank));
  CLI::App* const command = group->add_subcommand(name.substr(blank + 1), help);
  command->callback([this, body = std::move(body)] { exit_code_ = body(); });
  return Command(command);
}

/// A misspelt name is told before the parser complains of what follows from it.
void CommandLine::require_known_names() const {
  const CLI::App* command = app_.get();
  for (auto name = arguments_.begin(); !command->get_subcommands({}).empty(); ++name) {
    if (name == arguments_.end()) return;
    if (name->starts_with('-')) {
      require_option_without_subcommand(*name, *command);
      return;
    }
    std::vector<std::string> known;
    for (const CLI::App* sub : command->get_subcommands({})) known.push_back(sub->get_name());
    require_name("subcommand", *name, known);
    command = command->get_subcommand(*name);
  }
  const std::vector<std::string> options = option_names(*command);
  for (const std::string& argument : arguments_) {
    if (argument == "--") return;
    require_option(argument, options);
  }
  require_named_images(arguments_, *command);
}

int CommandLine::run() {
  require_known_names();
  try {
    app_->parse(std::vector<std::string>(arguments_.rbegin(), arguments_.rend()));
  } catch (const CLI::ExcludesError& error) {
    throw UsageError(error.what() + taken_for_scene(*app_));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // help and version
      app_->exit(error);
      return kOk;
    }
    std::string text = error.what();
    while (text.ends_with('\n') || text.ends_with('.')) text.pop_back();
    throw UsageError(text + "; see pipeline " + (arguments_.empty() ? "" : arguments_[0] + " ") +
                     "--help");
  }
  return exit_code_;
}

}  // namespace xgm::cli
