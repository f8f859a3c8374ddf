// For packaging/test: which test cases a change reaches, or a name means. Prints a line "PROGRAM FILTER" for each test program.
#include <cstdio>
#include <iostream>

#include "tests/rules/reach.h"

namespace {

using namespace cullscope::rules;

void print(const TestSelection& selection) {
    for (const auto& [program, filters] : selection) {
        std::cout << program << ' ';
        for (size_t i = 0; i < filters.size(); ++i) std::cout << (i > 0 ? ":" : "") << filters[i];
        std::cout << '\n';
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.size() == 2 && arguments[0] == "--changed") {
        std::vector<std::filesystem::path> changed;
        for (std::string line; std::getline(std::cin, line);) changed.emplace_back(line);
        print(testsReached(arguments[1], changed));
        return 0;
    }
    if (arguments.size() == 3 && arguments[0] == "--only") {
        const TestSelection selection = testsNamed(arguments[2], arguments[1]);
        if (!selection.empty()) {
            print(selection);
            return 0;
        }
        std::string programs;
        for (const std::string& program : testPrograms(arguments[2])) programs += " " + program;
        std::cerr << "There is no test program and no suite \"" << arguments[1] << "\". Programs:" << programs << "\n";
        return 2;
    }
    std::cerr << "reached_tests --changed ROOT < FILES | reached_tests --only NAME ROOT\n";
    return 2;
}
