// Any text as a fabric file. What is accepted is a fabric, and the same when it is written and read again.
#include <drench/files/fabric_file.h>
#include <drench/wet_laws.h>

#include <string_view>

#include "choices.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace drench;
    Fabric fabric;
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    if (!fuzz::accepts([&] { fabric = fabricFromText(text); }, "")) return 0;
    validate(fabric);
    const WetLaws laws(fabric);
    const std::string written = fabricText(fabric);
    if (fabricText(fabricFromText(written)) != written) fuzz::fail("it is not what was written");
    return 0;
}
