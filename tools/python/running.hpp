// Calls of the library that run without Python's lock, and can be stopped from Python.
#pragma once

#include <winnow/context.hpp>

#include <functional>

#include <pybind11/pybind11.h>

namespace winnow::python {

// Runs `call` on a thread of its own, with Python's lock let go. The caller's thread meanwhile
// hears signals, and calls `progress` (or None) with a stage, what is done, of how much, and the
// unit. An exception of either cancels `context`, and is raised when the call has ended; else that
// of the call. The context can be used again afterwards.
void run(Context& context, const pybind11::object& progress, const std::function<void()>& call);

}  // namespace winnow::python
