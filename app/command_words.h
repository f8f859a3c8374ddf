#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "core/base/terminal_text.h"

// What both programs do with the words of their command line.
namespace cullscope {

inline constexpr const char* kEmptyValue = "its value is empty; leave the option out, or say what it is";

/// Options of a program and its commands that take a value refuse an empty one, which would else pass for none at all.
inline void refuseEmptyValues(CLI::App& app) {
    for (CLI::Option* option : app.get_options([](const CLI::Option* each) { return each->get_items_expected_max() > 0; }))
        option->check([](const std::string& text) { return text.empty() ? std::string(kEmptyValue) : std::string(); });
    for (CLI::App* command : app.get_subcommands({})) refuseEmptyValues(*command);
}

/// Refuses `--option=`, to which CLI11 gives the next word as its value, even where that is an option. Throws CLI::ParseError.
inline void refuseEmptyAssignments(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--") return;
        if (word.starts_with("--") && word.find('=') == word.size() - 1)
            throw CLI::ValidationError(word.substr(0, word.size() - 1), kEmptyValue);
    }
}

/// What is wrong with the words is said on one line that begins with the program's name. To be called before commands are added,
/// which inherit it.
inline void sayFailuresOnOneLine(CLI::App& app) {
    app.failure_message([program = app.get_name()](const CLI::App*, const CLI::Error& failure) {
        return fmt::format("{}: {}\nRun with --help for more information.\n", program, terminalLine(failure.what()));
    });
}

}  // namespace cullscope
