#include "python/errors.hpp"

#include <winnow/error.hpp>
#include <winnow/options.hpp>
#include <winnow/parts.hpp>

#include <array>
#include <exception>

namespace winnow::python {

namespace {

namespace py = pybind11;

// Live as long as the process.
py::handle error_type, missing_part_type;

void raise(py::handle type, const Error& error) {
  const py::object raised = type(spelled(error.what()));
  raised.attr("kind") = name_of(error.kind());
  PyErr_SetObject(type.ptr(), raised.ptr());
}

}  // namespace

std::string spelled(const std::string& text) {
  return spell_options(text, [](const std::string& name) {
    constexpr std::array calls{"convert", "info", "progressive", "simplify"};
    for (const char* call : calls) {
      if (name == call) return "winnow." + name;
    }
    if (name == "extract") return std::string("winnow.Progressive");
    return "`" + (name == "from" ? "from_" : name) + "`";
  });
}

void add_errors(py::module_& module) {
  error_type = PyErr_NewExceptionWithDoc(
      "winnow.Error",
      "What winnow could not do. `kind` is 'usage' (options that make no sense), 'bad_input',\n"
      "'resources' (memory, disk), 'cancelled' or 'failed'; the message is one line.",
      nullptr, nullptr);
  missing_part_type = PyErr_NewExceptionWithDoc(
      "winnow.MissingPart", "This winnow was built without a part that the call needs.",
      error_type.ptr(), nullptr);
  module.attr("Error") = error_type;
  module.attr("MissingPart") = missing_part_type;
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const MissingPart& error) {
      raise(missing_part_type, error);
    } catch (const Error& error) {
      raise(error_type, error);
    }
  });
}

}  // namespace winnow::python
