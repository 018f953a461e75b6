// Options as a dict of texts, by the tables of the library.
#pragma once

#include <winnow/options.hpp>

#include <map>
#include <span>
#include <stdexcept>
#include <string>

#include <pybind11/pybind11.h>

namespace winnow::python {

using Texts = std::map<std::string, std::string>;

// Throws Error(usage) where a text is no value of its option. Only names of the table are in
// `texts`.
template <typename Options>
void read(Options& options, std::span<const Option<Options>> table, const Texts& texts) {
  for (const Option<Options>& option : table) {
    if (const auto found = texts.find(option.name); found != texts.end())
      option.set(options, found->second);
  }
}

// Rows of the table, as tuples: name, what its value is called, heading, help, words that it takes.
template <typename Options>
pybind11::list rows_of_table(std::span<const Option<Options>> table) {
  pybind11::list rows;
  for (const Option<Options>& option : table) {
    pybind11::list words;
    for (const std::string& word : option.value.words) words.append(word);
    rows.append(pybind11::make_tuple(option.name, option.takes, option.group, option.help, words));
  }
  return rows;
}

}  // namespace winnow::python
