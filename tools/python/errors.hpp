// The library's errors as exceptions of Python, and its words as this module says them.
#pragma once

#include <string>

#include <pybind11/pybind11.h>

namespace winnow::python {

// A text of the library, with calls and options as Python has them.
std::string spelled(const std::string& text);

// Adds winnow.Error, with `kind`, and winnow.MissingPart to the module, and raises them from now
// on.
void add_errors(pybind11::module_& module);

}  // namespace winnow::python
