#include "io/bytes.hpp"
#include "cli/args.hpp"
#include "args.hpp"
#include <base/up.hpp>
#include <winnow/ok.hpp>
#include <CLI/CLI.hpp>
