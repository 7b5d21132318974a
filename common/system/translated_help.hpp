// The help of CLI11 in the reader's language.
#pragma once

#include "common/system/translation.hpp"

#include <CLI/CLI.hpp>

#include <utility>

namespace rt {

/// Translates the words around a command's help and the descriptions of its options.
inline void translate_help(CLI::App& command) {
    for (const auto& [of_cli, word] :
         {std::pair("REQUIRED", to_translate("(required)")),
          std::pair("Needs", to_translate("with")), std::pair("Excludes", to_translate("without")),
          std::pair("Usage", to_translate("Usage")), std::pair("Options", to_translate("Options")),
          std::pair("Positionals", to_translate("Arguments"))})
        command.get_formatter()->label(of_cli, tr(word));
    for (CLI::Option* option : command.get_options()) {
        option->description(tr_text(option->get_description()));
        option->type_name(tr(option->get_type_name()));
    }
}

}  // namespace rt
