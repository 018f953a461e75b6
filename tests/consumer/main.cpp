// Makes a scan, makes it small, and checks the count.
#include <winnow/error.hpp>
#include <winnow/generate.hpp>
#include <winnow/simplify.hpp>

#include <cstdio>

int main() {
  try {
    winnow::Context context;
    context.memory = std::uint64_t{256} << 20;

    winnow::GenerateOptions scan;
    scan.faces = 200'000;
    scan.force = true;
    winnow::generate(context, "scan.ply", scan);

    winnow::SimplifyOptions options;
    options.target = winnow::Target::grid(50);
    options.force = true;
    const winnow::SimplifyReport report =
        winnow::simplify(context, "scan.ply", "small.ply", options);

    std::printf("%llu faces became %llu\n", static_cast<unsigned long long>(report.input.faces),
                static_cast<unsigned long long>(report.output.faces));
    const bool plausible = report.output.faces > 0 && report.output.faces < report.input.faces / 2;
    return plausible ? 0 : 1;
  } catch (const winnow::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_code();
  }
}
