#pragma once
#include <winnow/ok.hpp>

#include "base/other.hpp"
#include "io/bytes.hpp"

#include <cstdint>
