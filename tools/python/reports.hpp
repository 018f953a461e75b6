// Reports of the library as dicts, by the names of `--json`.
#pragma once

#include <winnow/compare.hpp>
#include <winnow/convert.hpp>
#include <winnow/info.hpp>
#include <winnow/progressive.hpp>
#include <winnow/simplify.hpp>

#include <pybind11/pybind11.h>

namespace winnow::python {

pybind11::dict dict_of(const SimplifyReport& report);
pybind11::dict dict_of(const ConvertReport& report);
pybind11::dict dict_of(const InfoReport& report);
pybind11::dict dict_of(const CompareReport& report);
pybind11::dict dict_of(const ProgressiveReport& report);
pybind11::dict dict_of(const ProgressiveInfo& info);
pybind11::dict dict_of(const ExtractReport& report);

}  // namespace winnow::python
