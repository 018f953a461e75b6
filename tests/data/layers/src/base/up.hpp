#pragma once
#include <winnow/ok.hpp>
#include <cstdint>
#include "base/other.hpp"
#include "io/bytes.hpp"
