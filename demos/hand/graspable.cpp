#include "hand/graspable.h"

#include "bullet/fluid/rigid_shelter.h"
#include "stage/stage.h"
#include "world/vectors.h"

namespace drench::demo {

std::vector<Graspable> graspables(Scene& scene) {
    std::vector<Graspable> sheets;
    for (Stage* const stage : scene.stages())
        for (SceneCloth* const sheet : stage->sheets())
            sheets.push_back({&stage->world(), &sheet->body(), &sheet->wet()});
    return sheets;
}

std::optional<SolidHit> firstSolid(SceneWorld& world, const btVector3& from, const btVector3& to) {
    SolidRay ray(from, to);
    world.world().rayTest(from, to, ray);
    if (!ray.hasHit()) return std::nullopt;
    return SolidHit{double(ray.m_closestHitFraction), ray.m_hitNormalWorld};
}

std::optional<ClothHit> firstHit(const std::vector<Graspable>& sheets, const viewer::Ray& ray) {
    std::optional<ClothHit> first;
    for (const Graspable& sheet : sheets)
        for (int f = 0; f < sheet.body->m_faces.size(); ++f) {
            const btSoftBody::Face& face = sheet.body->m_faces[f];
            const auto distance =
                distanceTo(ray, pictureVector(face.m_n[0]->m_x), pictureVector(face.m_n[1]->m_x),
                           pictureVector(face.m_n[2]->m_x));
            if (!distance || (first && double(*distance) >= first->distance)) continue;
            first = ClothHit{sheet, f, toBullet((ray.origin + *distance * ray.direction).cast<double>()),
                             double(*distance)};
        }
    if (!first) return std::nullopt;
    constexpr double onSolid = 0.02;  // m, tolerance for cloth that lies on a solid
    const btVector3 from = toBullet(ray.origin.cast<double>()),
                    direction = toBullet(ray.direction.cast<double>());
    const double max = first->distance - onSolid;
    if (max > 0 && firstSolid(*first->sheet.world, from, from + direction * btScalar(max)))
        return std::nullopt;
    return first;
}

}  // namespace drench::demo
