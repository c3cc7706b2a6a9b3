// The state of a layer, for snapshots.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bullet/layer/layer.h"
#include "bullet/small_steps/moving_sheet.h"
#include "bullet/state/body_state.h"
#include "bullet/state/bullet_pass.h"
#include "bullet/state/snapshot_sections.h"
#include "checks/checks.h"
#include "state/checksum.h"
#include "state/snapshot_bytes.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// The last parameters of a fabric, which snapshots of format 1 do not have.
constexpr std::ptrdiff_t parametersSinceFormat1 = 2;

template <typename... Parts>
[[noreturn]] void refuseSheet(const Parts&... parts) {
    refuse<std::runtime_error>("the snapshot is of another sheet: ", parts...);
}

void checkSame(const char* what, std::uint64_t saved, std::uint64_t here) {
    if (saved != here) refuseSheet("it has ", saved, ' ', what, ", and this one has ", here);
}

// Tolerance for differences between compilers for the same body.
void checkAlike(const char* what, std::size_t index, float saved, double here) {
    constexpr double rounding = 1e-5;
    if (!(std::abs(double(saved) - here) <= rounding * (1 + std::abs(here))))
        refuseSheet(what, ' ', index, " is at ", sixDigits(double(saved)), " m there, and at ",
                    sixDigits(here), " m here");
}

}  // namespace

template <typename Each>
void WetCloth::Layer::forEachSection(Each each) {
    each("CLTH", &Layer::clothState);
    each("BODY", &Layer::bodyState);
    each("WATR", &Layer::waterState);
    each("MECH", &Layer::mechanicsState);
    each("TUCH", &Layer::touchState);
    each("AIRS", &Layer::airState);
    each("TIME", &Layer::momentState);
}

Snapshot WetCloth::Layer::snapshot() {
    checkBetweenSteps();
    StateWriter all;
    forEachSection([&](const char* name, auto state) {
        StateWriter section;
        BulletPass pass(section, world);
        (this->*state)(pass);
        writeSection(all, name, section);
    });
    StateWriter sources;
    saveSources(sources);
    writeSection(all, sourcesSection, sources);
    const auto count = [](int size) { return static_cast<std::uint64_t>(size); };
    Snapshot made(snapshotBytes({sizeof(btScalar), count(body.m_nodes.size()), count(body.m_links.size()),
                                 count(body.m_faces.size()), topologyHash()},
                                all.bytes()));
    // A snapshot that could not be restored is refused now rather than by `restore`.
    try {
        checkSections(made);
    } catch (const std::runtime_error& problem) {
        refuse<std::runtime_error>("no snapshot can be made of this sheet, which is not well: ",
                                   reasonOf(problem));
    }
    return made;
}

void WetCloth::Layer::restore(const Snapshot& snapshot) {
    checkBetweenSteps();
    checkSameSheet(snapshot);
    checkSections(snapshot);
    restoreSections(snapshot);
    pose.gather(body, mesh, mechanics.gravity);  // positions for repairs
    world.updateAabbs();                         // rays search there before the next step updates them
}

void WetCloth::Layer::checkBetweenSteps() const {
    if (supplying)
        refuse<std::logic_error>("within a step a sheet has no state to keep or restore; wait for its end");
    if (!watch.bodyIsAlive() || !body.getBroadphaseHandle() || !isInWorld())
        refuse<std::logic_error>(
            "the body is in no world, where its contacts had names; add it to the world of its "
            "WetCloth first");
    if (!fits())
        refuse<std::logic_error>(
            "the body has got or lost nodes, links or faces since the last step; step once, so that "
            "its WetCloth can follow");
}

void WetCloth::Layer::checkSameSheet(const Snapshot& snapshot) const {
    if (snapshot.precision() != sizeof(btScalar))
        refuseSheet("it comes from ", snapshot.precision() == 4 ? "single" : "double",
                    "-precision Bullet, and this library is for ",
                    sizeof(btScalar) == 4 ? "single" : "double", " precision");
    checkSame("nodes", snapshot.nodes(), static_cast<std::uint64_t>(body.m_nodes.size()));
    checkSame("links", snapshot.links(), static_cast<std::uint64_t>(body.m_links.size()));
    checkSame("faces", snapshot.faces(), static_cast<std::uint64_t>(body.m_faces.size()));
    if (snapshot.topology() != topologyHash())
        refuseSheet(
            "its links or faces join other nodes; build the body in the same way, and attach before links "
            "change");
}

std::uint64_t WetCloth::Layer::topologyHash() const {
    StateWriter writer;
    for (const auto& triangle : mechanics.shape.triangles)
        for (const int node : triangle) writer.write(static_cast<std::int32_t>(node));
    for (const LinkNodes& link : mechanics.shape.links) {
        for (const int node : link.nodes) writer.write(static_cast<std::int32_t>(node));
        writer.write(link.bending);
    }
    return checksumOf(writer.bytes());
}

// Changes nothing.
void WetCloth::Layer::checkSections(const Snapshot& snapshot) {
    StateReader reader(snapshot.state());
    forEachSection([&](const char* name, auto state) {
        StateReader section = readSection(reader, name);
        BulletPass pass(section, StatePass::Kind::check, world);
        (this->*state)(pass);
        checkEnd(section, name);
    });
    checkSources(readSection(reader, sourcesSection));
    checkEnd(reader, "END");
}

// Loads the sources first, because a source of an application may throw.
// @pre the sections have been checked
void WetCloth::Layer::restoreSections(const Snapshot& snapshot) {
    StateReader ahead(snapshot.state());
    forEachSection([&](const char* name, auto) { readSection(ahead, name); });
    loadSources(readSection(ahead, sourcesSection));
    StateReader reader(snapshot.state());
    forEachSection([&](const char* name, auto state) {
        StateReader section = readSection(reader, name);
        BulletPass pass(section, StatePass::Kind::restore, world);
        (this->*state)(pass);
    });
}

// Constant data, to recognise another sheet.
void WetCloth::Layer::clothState(BulletPass& pass) {
    const std::string name = pass.value(fabric.name);
    const std::vector<FabricParameter>& parameters = fabricParameters();
    const auto check = [&](const FabricParameter& parameter) {
        const double here = fabric.*parameter.member, saved = pass.value(here);
        if (saved != here)
            refuseSheet("the ", parameter.name, " of its fabric, ", name, ", is ", saved, ' ', parameter.unit,
                        ", and that of this one's, ", fabric.name, ", is ", here);
    };
    const auto ofFormat1 = parameters.end() - parametersSinceFormat1;
    const auto count = static_cast<std::size_t>(ofFormat1 - parameters.begin());
    checkSame("parameters of its fabric", pass.count(count), count);
    std::for_each(parameters.begin(), ofFormat1, check);
    for (std::size_t i = 0; i < mechanics.shape.restLengths.size(); ++i) {
        const auto here = double(mechanics.shape.restLengths[i]);
        checkAlike("the end of link", i, pass.value(static_cast<float>(here)), here);
    }
    for (std::size_t n = 0; n < coordinates.size(); ++n)
        for (const double here : coordinates[n])
            checkAlike("the material coordinate of node", n, pass.value(static_cast<float>(here)), here);
    // Drench 0.2 did not have them; cotton's are left out.
    const Fabric cotton;
    const auto isCottons = [&](const FabricParameter& parameter) {
        return double(fabric.*parameter.member) == double(cotton.*parameter.member);
    };
    if (pass.saves() ? std::all_of(ofFormat1, parameters.end(), isCottons) : !pass.hasMore()) return;
    std::for_each(ofFormat1, parameters.end(), check);
}

void WetCloth::Layer::bodyState(BulletPass& pass) {
    const bool isDeformableHere = deformable != nullptr;
    if (pass.value(isDeformableHere) != isDeformableHere)
        refuseSheet(isDeformableHere ? "it was in a soft-rigid world, and this one is in a deformable one"
                                     : "it was in a deformable world, and this one is in a soft-rigid one");
    BodyState state(body, isDeformableHere);
    pass.part(state);
}

void WetCloth::Layer::waterState(BulletPass& pass) {
    static_cast<StatePass&>(pass).part(moisture);
    for (Arrival& arrival : arrivals) {
        pass.number(arrival.carried, 0);
        pass.number(arrival.mass, 0);
        pass.vector(arrival.momentum);
    }
}

void WetCloth::Layer::mechanicsState(BulletPass& pass) {
    if (pass.restores()) mechanics.evaluate(laws, moisture);
    pass.numbers(mechanics.masses, 0, BulletPass::farthest);
    pass.flag(mechanics.movedBySmallSteps);
    pass.number(mechanics.smallSteps, 0);
    pass.number(mechanics.heldSubsteps, 0);
    if (pass.restores()) heldSubsteps = mechanics.heldSubsteps;
    const bool moves = pass.value(mechanics.moving != nullptr);
    if (!moves) {
        if (pass.restores()) mechanics.moving.reset();
        return;
    }
    std::shared_ptr<MovingSheet> moving = mechanics.moving;
    if (!moving) moving = std::make_shared<MovingSheet>(mechanics);
    pass.part(moving->cloth);
    pass.part(moving->memory);
    if (!pass.restores()) return;
    mechanics.moving = std::move(moving);
    mechanics.hasJumped = false;
    mechanics.near.observe(body);
}

void WetCloth::Layer::touchState(BulletPass& pass) {
    pass.part(mechanics.sheetFriction);
    pass.part(stockContacts);
    ContactState touched(body, deformable != nullptr);
    pass.part(touched);
    for (Contact& contact : contacts) {
        pass.number(contact.touchesUntil);
        pass.number(contact.liesUntil);
    }
    pass.number(touchedUntil);
    layersState(pass);
}

// Drench 0.2 knew no layers.
void WetCloth::Layer::layersState(BulletPass& pass) {
    if (pass.restores()) {
        mechanics.touches = LayerTouches();
        mechanics.touches.areListed = mechanics.moving != nullptr;
        layers = ClothLayers(fabric, mesh.size(), mechanics.lightPressure);
    }
    const bool isUntouched = mechanics.touches.contacts.empty() && !layers.isPressed() && !touching;
    if (pass.saves() ? isUntouched : !pass.hasMore()) return;
    mechanics.touches.state(pass, mesh.size());
    pass.part(layers);
    const bool passes = pass.value(touching != nullptr);
    if (!passes) return;
    if (pass.restores()) touchAccount();
    if (touching) return pass.part(*touching);
    // In a check nothing is made.
    AccountSupply unused({moisture, arrivals, submersion, body, watch}, 0, 1, 0);
    pass.part(unused);
}

void WetCloth::Layer::airState(BulletPass& pass) {
    pass.part(winds);
    pass.part(submersion);
    pass.part(fluidForces);
}

void WetCloth::Layer::momentState(BulletPass& pass) {
    pass.number(time, 0);
    std::vector<Drop> all(drops.begin(), drops.end());
    pass.list(
        all,
        [&](Drop& drop) {
            pass.vector(drop.position);
            pass.vector(drop.velocity);
            pass.number(drop.mass, 0);
            pass.number(drop.count, 0);
            pass.number(drop.time, 0);
            pass.number(drop.node, 0, double(mesh.size()) - 1);
        },
        maxDropsKept);
    if (pass.restores()) drops.assign(all.begin(), all.end());
}

void WetCloth::Layer::saveSources(StateWriter& writer) const {
    writer.write(static_cast<std::uint64_t>(suppliers.size()));
    for (const Supplier& supplier : suppliers) {
        StateWriter state, unnoticed;
        supplier.source->save(state);
        BulletPass pass(unnoticed, world);
        pass.part(*supplier.supply);
        for (const std::string& text : {supplier.source->name(), state.bytes(), unnoticed.bytes()})
            writer.write(text);
    }
}

void WetCloth::Layer::checkSources(StateReader reader) const {
    checkSame("sources", reader.read<std::uint64_t>(), suppliers.size());
    for (std::size_t i = 0; i < suppliers.size(); ++i) {
        const std::string saved = reader.readText(), here = suppliers[i].source->name();
        if (saved != here)
            refuseSheet("its source ", i, " is of the name ", saved, ", and this one's is ", here,
                        "; add the same sources in the same order");
        reader.readText();
        const std::string unnoticed = reader.readText();
        StateReader supply(unnoticed);
        BulletPass pass(supply, StatePass::Kind::check, world);
        pass.part(*suppliers[i].supply);
        checkEnd(supply, sourcesSection);
    }
    checkEnd(reader, sourcesSection);
}

// Loads all sources or none. @pre they have been checked
void WetCloth::Layer::loadSources(StateReader reader) {
    std::vector<StateWriter> before(suppliers.size());
    for (std::size_t i = 0; i < suppliers.size(); ++i) suppliers[i].source->save(before[i]);
    StateReader unnoticed = reader;
    reader.read<std::uint64_t>();
    std::size_t tried = 0;
    try {
        while (tried < suppliers.size()) {
            reader.readText();
            const std::string saved = reader.readText();
            reader.readText();
            StateReader state(saved);
            suppliers[tried++].source->load(state);
            checkEnd(state, sourcesSection);
        }
    } catch (...) {
        for (std::size_t i = 0; i < tried; ++i) {
            StateReader back(before[i].bytes());
            suppliers[i].source->load(back);
        }
        throw;
    }
    restoreUnnoticed(unnoticed);
}

void WetCloth::Layer::restoreUnnoticed(StateReader reader) {
    reader.read<std::uint64_t>();
    for (Supplier& supplier : suppliers) {
        reader.readText();
        reader.readText();
        const std::string saved = reader.readText();
        StateReader state(saved);
        BulletPass pass(state, StatePass::Kind::restore, world);
        pass.part(*supplier.supply);
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
