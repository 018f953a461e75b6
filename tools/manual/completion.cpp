// Completions for bash, zsh and fish.
#include "manual/command_table.hpp"

namespace winnow::manual {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

std::vector<std::string> names_of(const CommandTable& command) {
  std::vector<std::string> names;
  for (const OptionLine& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::vector<std::string> commands_of(const std::vector<CommandTable>& all) {
  std::vector<std::string> names;
  for (const CommandTable& command : all) {
    if (command.name != "winnow") names.push_back(command.name);
  }
  return names;
}

// What follows an option: its choices, a file, or nothing that could be completed.
std::string bash_values(const CommandTable& command) {
  std::string cases;
  for (const OptionLine& option : command.options) {
    if (option.value.empty() || option.positional()) continue;
    std::string patterns;
    for (const std::string& name : option.names)
      patterns += (patterns.empty() ? "" : "|") + command.name + ":" + name;
    cases += "    " + patterns + ")";
    if (!option.choices.empty()) {
      cases += " _winnow_words '" + joined(option.choices) + "'; return ;;\n";
    } else if (option.takes_file()) {
      cases += std::string(" _winnow_files ") + (option.takes_directory() ? "-d" : "-f") +
               "; return ;;\n";
    } else {
      cases += " return ;;\n";
    }
  }
  return cases;
}

// What stands without an option, where it is no file.
std::string bash_places(const std::vector<CommandTable>& all) {
  std::string cases;
  for (const CommandTable& command : all) {
    for (const OptionLine& option : command.options) {
      if (!option.positional()) continue;
      if (!option.choices.empty())
        cases += "      " + command.name + ") _winnow_words '" + joined(option.choices) + "' ;;\n";
      if (option.takes_directory()) cases += "      " + command.name + ") _winnow_files -d ;;\n";
    }
  }
  return cases;
}

// Words in single quotes of the shell, with what _arguments takes for its own escaped.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') {
      out += R"('\'')";
    } else if (c == '[' || c == ']' || c == ':' || c == '\\') {
      out += std::string(R"(\)") + c;
    } else {
      out += c;
    }
  }
  return out;
}

std::string zsh_value(const OptionLine& option) {
  if (option.value.empty()) return "";
  std::string action;
  if (!option.choices.empty()) {
    action = "(" + joined(option.choices) + ")";
  } else if (option.takes_file()) {
    action = option.takes_directory() ? "_path_files -/" : "_files";
  }
  return ":" + zsh_text(option.value) + ":" + action;
}

std::string zsh_option(const OptionLine& option) {
  if (option.positional())
    return std::string(" \\\n        '") + (option.several ? "*" : "") + zsh_value(option) + "'";
  std::string lines;
  for (const std::string& name : option.names) {
    // Whichever of its names was given, the others are not offered any more.
    lines += " \\\n        '(" + joined(option.names) + ")" + name + "[" +
             zsh_text(option.description) + "]" + zsh_value(option) + "'";
  }
  return lines;
}

// A word in single quotes of fish.
std::string fish_text(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += (c == '\'' || c == '\\' ? "\\" : "") + std::string(1, c);
  return out + "'";
}

std::string fish_value(const OptionLine& option) {
  if (!option.choices.empty()) return " -a " + fish_text(joined(option.choices));
  if (option.takes_directory()) return " -a '(__fish_complete_directories)'";
  return option.takes_file() ? " -F" : "";
}

// `condition`: where it is offered.
std::string fish_option(const std::string& condition, const OptionLine& option) {
  std::string line = "complete -c winnow -n '" + condition + "'";
  if (option.positional()) return line + fish_value(option) + "\n";
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  const bool file = option.takes_file() && !option.takes_directory();
  if (!option.value.empty()) line += file ? " -r" : " -x";
  return line + fish_value(option) + " -d " + fish_text(option.description) + "\n";
}

}  // namespace

std::string bash_completion(const std::vector<CommandTable>& all) {
  std::string text = "# bash completion for winnow\n\n";
  text += "_winnow_words() { mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$cur\"); }\n";
  text += R"(_winnow_files() { compopt -o filenames 2>/dev/null; )"
          R"(mapfile -t COMPREPLY < <(compgen "$1" -- "$cur"); )"
          "}\n\n";
  text +=
      "_winnow() {\n  local cur=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n";
  // "--refine=volume" comes as three words.
  text += "  [[ $before == = && COMP_CWORD -gt 2 ]] && before=${COMP_WORDS[COMP_CWORD - 2]}\n";
  text += "  [[ $cur == = ]] && cur=\n";
  text += "  COMPREPLY=()\n";
  text += "  if ((COMP_CWORD == 1)); then\n    _winnow_words '" + joined(commands_of(all)) +
          " help " + joined(names_of(all.front())) + "'\n    return\n  fi\n";
  text += "  if [[ ${COMP_WORDS[1]} == help ]]; then\n    _winnow_words '" +
          joined(commands_of(all)) + "'\n    return\n  fi\n";
  text += "  case ${COMP_WORDS[1]}:$before in\n";
  for (const CommandTable& command : all) text += bash_values(command);
  text += "  esac\n  if [[ $cur != -* ]]; then\n    case ${COMP_WORDS[1]} in\n" + bash_places(all) +
          "      *) _winnow_files -f ;;\n    esac\n    return\n  fi\n";
  text += "  case ${COMP_WORDS[1]} in\n";
  for (const CommandTable& command : all) {
    if (command.name == "winnow") continue;
    text += "    " + command.name + ") _winnow_words '" + joined(names_of(command)) + "' ;;\n";
  }
  return text + "  esac\n}\n\ncomplete -F _winnow winnow\n";
}

std::string zsh_completion(const std::vector<CommandTable>& all) {
  std::string text = "#compdef winnow\n\n_winnow() {\n  local -a commands\n  commands=(\n";
  for (const CommandTable& command : all) {
    if (command.name == "winnow") continue;
    text += "    '" + command.name + ":" + zsh_text(command.description) + "'\n";
  }
  text += "    'help:Show the options of a command'\n  )\n";
  text += "  if ((CURRENT == 2)); then\n    _describe command commands\n";
  text += "    _arguments";
  for (const OptionLine& option : all.front().options) text += zsh_option(option);
  text += "\n    return\n  fi\n";
  text += "  local command=$words[2]\n  shift words\n  ((CURRENT--))\n  case $command in\n";
  for (const CommandTable& command : all) {
    if (command.name == "winnow") continue;
    text += "    " + command.name + ")\n      _arguments";
    for (const OptionLine& option : command.options) text += zsh_option(option);
    text += "\n      ;;\n";
  }
  text += "    help)\n      _describe command commands\n      ;;\n";
  return text + "  esac\n}\n\n_winnow \"$@\"\n";
}

std::string fish_completion(const std::vector<CommandTable>& all) {
  std::string text =
      "# fish completion for winnow\n\n"
      "# Whether the command is this one; without one: whether there is none yet.\n"
      "function __winnow_command\n"
      "  set -l words (commandline -opc)\n"
      "  test \"$words[2]\" = \"$argv[1]\"\n"
      "end\n\n"
      "complete -c winnow -f\n";
  for (const OptionLine& option : all.front().options)
    text += fish_option("__winnow_command", option);
  for (const CommandTable& command : all) {
    if (command.name == "winnow") continue;
    for (const char* condition : {"", " help"}) {
      text += std::string("complete -c winnow -n '__winnow_command") + condition + "' -a " +
              command.name + " -d " + fish_text(command.description) + "\n";
    }
    for (const OptionLine& option : command.options)
      text += fish_option("__winnow_command " + command.name, option);
  }
  return text +
         "complete -c winnow -n '__winnow_command' -a help -d 'Show the options of a command'\n";
}

}  // namespace winnow::manual
