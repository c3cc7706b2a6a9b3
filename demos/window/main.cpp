// drench-demo: wet cloth to watch, in a window or as tables and pictures.
#include <exception>
#include <iostream>

#include "run/run_options.h"
#include "run/runners.h"
#include "viewer/window.h"
#include "window/window_run.h"

int main(int argc, char** argv) {
    using namespace drench::demo;
    const ParsedOptions parsed = parseOptions(argc, argv);
    if (parsed.exitStatus) return *parsed.exitStatus;
    try {
        checkTargets(parsed.options);
        if (parsed.options.headless) {
            const auto scene = makeScene(parsed.options);
            return runHeadless(*scene, parsed.options);
        }
        if (!drench::viewer::Window::displayAvailable()) {
            std::cerr << "drench-demo: there is no display to open a window on; run with --headless\n";
            return 2;
        }
        return runInWindow(parsed.options);
    } catch (const std::exception& problem) {
        std::cerr << "drench-demo: " << problem.what() << '\n';
        return 2;
    }
}
