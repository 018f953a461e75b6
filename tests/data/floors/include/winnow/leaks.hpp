#pragma once
#include <winnow/ok.hpp>

#include "ok.hpp"

#include <vector>

#include <tbb/task.h>
#include <unistd.h>
