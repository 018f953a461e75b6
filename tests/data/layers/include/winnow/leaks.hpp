#pragma once
#include <tbb/task.h>
#include <unistd.h>
#include <vector>
#include "ok.hpp"
#include <winnow/ok.hpp>
