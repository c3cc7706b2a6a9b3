// Any body, fabric, world, step and order of calls for the layer in a real Bullet world: it refuses or goes on, and no
// body comes to anything that is no number.
#include <drench/drench.h>

#include <cmath>

#include "choices.h"
#include "random_cloth.h"
#include "world/scene_world.h"

namespace drench::fuzz {
namespace {

Eigen::Vector3d eigen(const btVector3& vector) {
    return {double(vector.x()), double(vector.y()), double(vector.z())};
}

// A world with a ball and one sheet, at which an application pulls as the input says.
class Play {
  public:
    explicit Play(Choices& choices)
        : choices_(choices), world_(randomWorld()), ball_(world_->addBall({0, 0, 0}, 0.3, 0)) {
        fabric_ = randomFabric(choices_);
        body_ = randomBody(choices_, world_->worldInfo(), fabric_);
        for (int n = 0; n < body_->m_nodes.size(); ++n) home_.push_back(body_->m_nodes[n].m_x);
        world_->addSoftBody(*body_);
        attach();
    }
    ~Play() {
        cloth_.reset();
        if (body_ && inWorld_) world_->removeSoftBody(*body_);
    }
    Play(const Play&) = delete;
    Play& operator=(const Play&) = delete;

    // Whether there still is a layer; one whose successor was refused is gone.
    bool goesOn() const { return cloth_ != nullptr; }

    void act() {
        const int what = choices_.whole(0, 31);
        accepts([&] {
            what < 8 ? bringWater(what) : what < 14 ? addSource(what) : what < 24 ? pull(what) : step();
        });
    }

  private:
    std::unique_ptr<demo::SceneWorld> randomWorld() {
        SmallStepSettings steps;
        steps.count = choices_.whole(0, 12);
        steps.tethers = choices_.oneIn(2);
        const bool deforms = choices_.oneIn(3), isStock = choices_.oneIn(2);
        return demo::makeWorld(deforms ? demo::WorldKind::deformable : demo::WorldKind::softRigid,
                               isStock || deforms ? demo::SolverKind::stock : demo::SolverKind::smallStep,
                               steps);
    }

    void attach() {
        SheetSettings settings;
        settings.waterSpeed = choices_.oneIn(4) ? choices_.around(0, 1e5) : 1;
        source_ = nullptr;
        cloth_.reset();
        cloth_ = std::make_unique<WetCloth>(world_->world(), *body_, fabric_, settings);
    }

    int node() {
        return choices_.whole(choices_.oneIn(16) ? -1 : 0,
                              body_->m_nodes.size() - (choices_.oneIn(16) ? 0 : 1));
    }

    void bringWater(int what) {
        const double mass = choices_.around(0, 0.05);
        switch (what) {
            case 0:
                return cloth_->addWater(node(), mass);
            case 1:
                return cloth_->addWater(node(), mass, wildVector(choices_, 20));
            case 2:
                return cloth_->soakFilm(10 * mass);
            case 3:
                return cloth_->soakPores(10 * mass);
            case 4:
                return cloth_->setWaterSpeed(choices_.around(0, 1e3));
            case 5:
                return void(cloth_->takeDrops());
            case 6:
                return cloth_->account("tap").addFilm(static_cast<std::size_t>(node()), mass);
            default:
                return void(cloth_->account("tap").takePores(static_cast<std::size_t>(node()), mass));
        }
    }

    void addSource(int what) {
        const Eigen::Vector3d position = eigen(wildVector(choices_, 2));
        const double rate = choices_.around(0, 1);
        switch (what) {
            case 8:
                source_ = &cloth_->add(Rain(1000 * rate));
                return;
            case 9:
                source_ = &cloth_->add(Spray(position, eigen(wildVector(choices_, 1)), rate));
                return;
            case 10:
                source_ = &cloth_->add(Pool(position.y()));
                return;
            case 11:
                source_ = &cloth_->add(Brush(position, choices_.around(0.01, 1), rate));
                return;
            case 12:
                source_ = &cloth_->add(WetBody(ball_));
                return;
            default:
                if (source_) cloth_->remove(*source_);
                source_ = nullptr;
        }
    }

    void pull(int what) {
        btSoftBody::Node& node = body_->m_nodes[choices_.whole(0, body_->m_nodes.size() - 1)];
        switch (what) {
            case 14:
                node.m_im = node.m_im > 0 ? 0 : btScalar(choices_.between(1, 1000));
                return;
            case 15:
                node.m_v = wildVector(choices_, 30);
                return;
            case 16:
                node.m_x = wildVector(choices_, 2);
                return;
            case 17:
                body_->setTotalMass(btScalar(choices_.between(0.01, 10)));
                return;
            case 18:
                return attach();
            case 19:
                return comeOrGo();
            case 20:
                if (choices_.oneIn(2)) return cloth_->setSurface(ball_, SurfaceKind::skin);
                return cloth_->setSurface(ball_, Surface{choices_.around(0, 5), 1, 1, choices_.around(0, 1)});
            case 21:
                body_->m_cfg.kDP = btScalar(choices_.between(0, 1));
                return;
            case 22:
                node.m_f = wildVector(choices_, 100);
                return;
            default:
                changeAir();
        }
    }

    // Into the world, with places that Bullet can stand, or out of it.
    void comeOrGo() {
        if (!inWorld_) repair();
        inWorld_ ? world_->removeSoftBody(*body_) : world_->addSoftBody(*body_);
        inWorld_ = !inWorld_;
    }

    void changeAir() {
        Air& air = cloth_->air();
        air.wind = eigen(wildVector(choices_, 30));
        air.humidity = choices_.around(0, 0.99);
        air.temperature = choices_.around(0, 60);
        air.vapourExchange = choices_.around(0, 1);
        air.shelterLength = choices_.around(0, 10);
    }

    void step() {
        const btScalar dt = btScalar(choices_.oneIn(3)   ? choices_.between(1e-4, 0.1)
                                     : choices_.oneIn(2) ? 1e-3
                                                         : 1 / 60.);
        if (!accepts([&] { world_->world().stepSimulation(dt, 1, dt); })) return repair();
        if (inWorld_ && !cloth_->health().finite) fail("the body is not finite");
        const Ledger ledger = cloth_->ledger();
        if (!(std::abs(ledger.imbalance()) <= 1e-6 * ledger.supplied + 1e-15)) fail("water is made or lost");
    }

    // What an application does whose step was refused.
    void repair() {
        world_->world().clearForces();
        for (int n = 0; n < body_->m_nodes.size(); ++n) {
            btSoftBody::Node& node = body_->m_nodes[n];
            node.m_x = node.m_q = home_[static_cast<std::size_t>(n)];
            node.m_v = node.m_f = btVector3(0, 0, 0);
        }
        cloth_->air() = Air();
        if (source_) cloth_->remove(*source_);
        source_ = nullptr;
    }

    Choices& choices_;
    std::unique_ptr<demo::SceneWorld> world_;
    btRigidBody& ball_;
    Fabric fabric_;
    std::unique_ptr<btSoftBody> body_;
    std::vector<btVector3> home_;  // where the nodes were at first
    std::unique_ptr<WetCloth> cloth_;
    const Source* source_ = nullptr;
    bool inWorld_ = true;
};

}  // namespace
}  // namespace drench::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace drench::fuzz;
    Choices choices(bytes, count);
    accepts([&] {
        Play play(choices);
        for (int acts = 0; choices.any() && acts < 64 && play.goesOn(); ++acts) play.act();
    });
    return 0;
}
