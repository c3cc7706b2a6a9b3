// Any text as an OBJ file. What is accepted is a mesh as the rest of the library wants it.
#include <drench/files/mesh_file.h>

#include <string_view>

#include "choices.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace drench;
    for (const bool texture : {false, true}) {
        MeshReadOptions reading;
        reading.texture = texture;
        MeshFile file;
        const std::string_view text(reinterpret_cast<const char*>(bytes), count);
        if (!fuzz::accepts([&] { file = meshFromText(text, reading); }, "")) continue;
        validate(file.mesh);
        if (file.vertexInFile.size() != file.mesh.vertices.size())
            fuzz::fail("nodes and vertices differ in number");
        if (texture) fuzz::accepts([&] { texturedCoordinates(file.mesh); });
    }
    return 0;
}
