// How many fields an aggregate has.
#pragma once

#include <cstddef>
#include <utility>

namespace winnow::test {

namespace field_count_detail {

struct Anything {
  template <typename Field>
  operator Field() const;
};

template <typename Aggregate, std::size_t... i>
constexpr bool takes(std::index_sequence<i...> /*numbers*/) {
  return requires {
    Aggregate{(static_cast<void>(i), Anything{})...};
  };
}

}  // namespace field_count_detail

// Of an aggregate without arrays and bases: the most values that can initialize it.
template <typename Aggregate, std::size_t count = 0>
constexpr std::size_t field_count() {
  if constexpr (field_count_detail::takes<Aggregate>(std::make_index_sequence<count + 1>())) {
    return field_count<Aggregate, count + 1>();
  } else {
    return count;
  }
}

}  // namespace winnow::test
