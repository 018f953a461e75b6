// Pages in the man macros, see man-pages(7).
#include <winnow/version.hpp>

#include "manual/command_table.hpp"

#include <array>
#include <utility>

namespace winnow::manual {

namespace {

constexpr std::array<std::pair<const char*, const char*>, 6> exit_codes{
    {{"0", "Done."},
     {"1",
      "Failed for a reason that no other code names; of compare, the distance is above "
      "--fail-above."},
     {"2",
      "Options that contradict each other or make no sense, or an output that exists already."},
     {"3", "The input is not what it should be; the message names the file and the place."},
     {"4", "The memory budget is too small, the disk is full, or the output's reader went away."},
     {"130", "Interrupted. Nothing is left under the output's name."}}};

// What is the same for every command that reads meshes.
const char* const hard_budget =
    R"(The resident set, mapped pages of the input included, stays below \fB--memory\fR )"
    "(512M unless given) "
    "and 32 MiB, whatever the size of input and output. A budget that is too small is refused at "
    "once, with "
    "the smallest that works.";

// The budget by command.
const char* memory_usage(const std::string& command) {
  if (command == "simplify")
    return "A cell of the result takes about 190 bytes of table and a face about 40, so that 512 "
           "MiB hold a "
           "result of about two million faces. What does not fit goes to scratch: beside the "
           "output, or "
           "where "
           R"(\fB--scratch\fR says. With \fB--dry-run\fR )"
           "the division of the budget and the scratch are "
           "shown, "
           "and nothing is done.";
  if (command == "sequence")
    return "One frame is held in memory while frames are read, 58 bytes a vertex, and some tiles "
           "of all frames while they are refined. What does not fit goes to scratch: beside the "
           "outputs, or "
           R"(where \fB--scratch\fR says. All frames take 48 bytes a vertex of a frame there.)";
  if (command == "convert")
    return "A vertex takes 48 bytes and a face 12. What does not fit goes to scratch: beside the "
           "output, or "
           R"(where \fB--scratch\fR says.)";
  if (command == "progressive")
    return "All faces are refined. What goes is kept in scratch, about 100 bytes a face, beside "
           R"(the output, or where \fB--scratch\fR says.)";
  if (command == "extract")
    return "The mesh that is extracted is held in memory, about 100 bytes a face. Where the budget "
           R"(is too small, the message names one that is enough for \fB--memory\fR.)";
  if (command == "view")
    return "Of a mesh a progressive file is made in scratch first, in bounded memory: in TMPDIR, "
           R"(else in /var/tmp, or where \fB--scratch\fR says. The browser holds what is seen, )"
           "about 100 bytes a face.";
  if (command == "info")
    return "Edges and connected parts are counted in memory, 24 bytes a face and 12 a vertex. What "
           "does not "
           "fit "
           R"(goes to scratch, where \fB--scratch\fR says, else to TMPDIR or /var/tmp.)";
  if (command == "compare-sequence")
    return "Each frame is compared by itself, as compare does it, in about 400 bytes a face. For "
           "the flicker the first frame of the original takes about 300 bytes a face.";
  if (command == "compare")
    return "The original is streamed and may have any size. The simplified mesh is held in memory, "
           "with "
           "about 400 bytes a face.";
  if (command == "generate")
    return "About two megabytes for each thread, whatever the number of faces.";
  return "Each command has a section of this name.";
}

// Lines that begin with a dot or quote are requests, a backslash begins an escape, and a plain
// hyphen may be set as a dash.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += R"(\e)";
    } else if (c == '-') {
      out += R"(\-)";
    } else {
      out += c;
    }
  }
  if (out.starts_with(".") || out.starts_with("'")) out.insert(0, R"(\&)");
  return out;
}

std::string bold(const std::string& text) {
  return R"(\fB)" + escaped(text) + R"(\fR)";
}

std::string italic(const std::string& text) {
  return R"(\fI)" + escaped(text) + R"(\fR)";
}

std::string page_name(const CommandTable& command) {
  return command.name == "winnow" ? "winnow" : "winnow-" + command.name;
}

// "IN", or "IN ...".
std::string value_of(const OptionLine& option) {
  return italic(option.value) + (option.several ? " ..." : "");
}

std::string synopsis(const CommandTable& command) {
  if (command.name == "winnow")
    return bold("winnow") + " " + italic("COMMAND") + " [" + italic("OPTIONS") + "]\n";
  std::string line = bold("winnow " + command.name);
  for (const OptionLine& option : command.options) {
    if (option.positional()) line += " " + value_of(option);
  }
  for (const OptionLine& option : command.options) {
    if (option.value == "OUT")
      line += " " + bold(option.names.front()) + " " + italic(option.value);
  }
  return line + " [" + italic("OPTIONS") + "]\n";
}

std::string option_entry(const OptionLine& option) {
  std::string head;
  for (const std::string& name : option.names) head += (head.empty() ? "" : ", ") + bold(name);
  if (!option.value.empty()) head += (head.empty() ? "" : " ") + value_of(option);
  std::string text = escaped(option.description);
  if (!option.choices.empty() && !option.open) {
    text += "\n.br\nOne of";
    for (const std::string& choice : option.choices)
      text += (&choice == option.choices.data() ? " " : ", ") + bold(choice);
    text += ".";
  }
  return ".TP\n" + head + "\n" + text + "\n";
}

// By group, in the order in which groups come first.
std::string options(const CommandTable& command) {
  std::vector<std::string> groups;
  std::string text;
  for (const OptionLine& option : command.options) {
    bool known = option.group.empty();
    for (const std::string& group : groups) known |= group == option.group;
    if (known) continue;
    groups.push_back(option.group);
    if (option.group != "Positionals" && option.group != "Options")
      text += ".SS " + escaped(option.group) + "\n";
    for (const OptionLine& other : command.options) {
      if (other.group == option.group) text += option_entry(other);
    }
  }
  return text;
}

}  // namespace

std::string man_page(const CommandTable& command, const std::vector<CommandTable>& all) {
  const bool whole = command.name == "winnow";
  const std::string& description = command.description;
  std::string page =
      ".TH " + escaped(page_name(command)) + R"( 1 "" "winnow )" WINNOW_VERSION "\" \"winnow\"\n";
  page += ".SH NAME\n" + escaped(page_name(command)) + R"( \- )" +
          escaped(whole ? "make huge triangle meshes small, in bounded memory" : description) +
          "\n";
  page += ".SH SYNOPSIS\n" + synopsis(command);
  page += ".SH DESCRIPTION\n" + escaped(description) + (description.ends_with(".") ? "\n" : ".\n");
  if (whole) {
    page += ".SH COMMANDS\n";
    for (const CommandTable& other : all) {
      if (other.name == command.name) continue;
      page += ".TP\n" + bold("winnow-" + other.name) + "(1)\n" + escaped(other.description) + "\n";
    }
  } else if (!command.remarks.empty()) {
    page += ".PP\n";
    for (const std::string& line : command.remarks) page += escaped(line) + "\n";
  }
  page += ".SH OPTIONS\n" + options(command);
  page += ".SH MEMORY USAGE\n" + std::string(hard_budget) + "\n.PP\n" + memory_usage(command.name) +
          "\n";
  page += ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : exit_codes)
    page += ".TP\n" + bold(code) + "\n" + meaning + "\n";
  if (!command.examples.empty()) {
    page += ".SH EXAMPLES\n.EX\n";
    for (const std::string& line : command.examples) page += escaped(line) + "\n";
    page += ".EE\n";
  }
  page += ".SH SEE ALSO\n";
  std::string separator;
  for (const CommandTable& other : all) {
    if (other.name == command.name) continue;
    page += separator + bold(page_name(other)) + "(1)";
    separator = ",\n";
  }
  return page + "\n";
}

}  // namespace winnow::manual
