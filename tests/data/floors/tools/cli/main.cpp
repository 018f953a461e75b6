#include <winnow/ok.hpp>

#include "args.hpp"
#include "cli/args.hpp"
#include "io/bytes.hpp"

#include <CLI/CLI.hpp>
#include <base/up.hpp>
