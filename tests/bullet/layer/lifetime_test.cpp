// Callbacks that belong to the application, and every order in which layer, body and world may end.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <optional>

#include "bullet/world/body_fields.h"
#include "bullet/world/worlds.h"

namespace drench::lifetime_test {
namespace {

struct Application {
    int calls = 0;
    btDynamicsWorld* world = nullptr;
    btScalar dt = 0;
};

void applicationCallback(btDynamicsWorld* world, btScalar dt) {
    auto* application = static_cast<Application*>(world->getWorldUserInfo());
    ++application->calls;
    application->world = world;
    application->dt = dt;
}

constexpr bool preTick = true;

TEST(PreTick, TheApplicationsCallbackAndUserInfoGoOnWorking) {
    test::SheetWorld rig(test::smallSheet);
    Application application;
    rig.world().setInternalTickCallback(applicationCallback, &application, preTick);
    {
        WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain());
        cloth.soakFilm(0.1);
        rig.bullet().step(0.1, 10);
        EXPECT_EQ(application.calls, 10);
        EXPECT_EQ(application.world, &rig.world());
        EXPECT_NEAR(application.dt, 0.01, 1e-6);
        EXPECT_EQ(rig.world().getWorldUserInfo(), &application);
        EXPECT_GT(cloth.moisture().totalPoreMass(), 0.0);
    }
    rig.bullet().step(0.1, 10);
    EXPECT_EQ(application.calls, 20);
    EXPECT_EQ(rig.world().getWorldUserInfo(), &application);
}

TEST(PreTick, ACallbackThatTheApplicationSetsLaterIsTakenUpByTheNextLayer) {
    test::SheetWorld rig(test::smallSheet);
    const auto second = test::smallSheet(rig.world().getWorldInfo());
    rig.world().addSoftBody(second.get());
    Application application;
    {
        WetCloth first(rig.world(), rig.sheet(), fabrics::cottonPlain());
        rig.world().setInternalTickCallback(applicationCallback, &application, preTick);
        WetCloth later(rig.world(), *second, fabrics::cottonPlain());
        first.soakFilm(0.1);
        later.soakFilm(0.1);
        rig.bullet().step(0.1, 10);
        EXPECT_EQ(application.calls, 10);
        EXPECT_GT(first.moisture().totalPoreMass(), 0.0);
        EXPECT_GT(later.moisture().totalPoreMass(), 0.0);
    }
    rig.bullet().step(0.1, 10);
    EXPECT_EQ(application.calls, 20);
    rig.world().removeSoftBody(second.get());
}

// An application that finds our callback in the slot and puts its own before it.
btInternalTickCallback callbackFoundInTheSlot = nullptr;
int callsBefore = 0;

void callbackThatChainsOn(btDynamicsWorld* world, btScalar dt) {
    ++callsBefore;
    callbackFoundInTheSlot(world, dt);
}

struct Slot : btDynamicsWorld {
    static btInternalTickCallback of(btDynamicsWorld& world) {
        return world.*(&Slot::m_internalPreTickCallback);
    }
};

TEST(PreTick, AnApplicationMayChainOntoTheLayerAndThenMakeAnother) {
    test::SheetWorld rig(test::smallSheet);
    const auto second = test::smallSheet(rig.world().getWorldInfo());
    rig.world().addSoftBody(second.get());
    Application application;
    callsBefore = 0;
    rig.world().setInternalTickCallback(applicationCallback, &application, preTick);
    WetCloth first(rig.world(), rig.sheet(), fabrics::cottonPlain());
    callbackFoundInTheSlot = Slot::of(rig.world());
    rig.world().setInternalTickCallback(callbackThatChainsOn, &application, preTick);
    first.soakFilm(0.1);
    rig.bullet().step(0.1, 10);
    EXPECT_EQ(callsBefore, 10);
    EXPECT_EQ(application.calls, 10);
    WetCloth later(rig.world(), *second, fabrics::cottonPlain());
    later.soakFilm(0.1);
    rig.bullet().step(0.1, 10);
    EXPECT_EQ(callsBefore, 20);
    EXPECT_EQ(application.calls, 20);
    EXPECT_NEAR(first.moisture().totalPoreMass(), 2 * later.moisture().totalPoreMass(),
                0.15 * first.waterMass());
    rig.world().removeSoftBody(second.get());
}

TEST(PreTick, ACallbackThatComesAgainIsCalledOnce) {
    test::SheetWorld rig(test::smallSheet);
    Application application;
    callsBefore = 0;
    rig.world().setInternalTickCallback(applicationCallback, &application, preTick);
    for (int times = 0; times < 3; ++times) {
        const WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain());
        if (times == 0) callbackFoundInTheSlot = Slot::of(rig.world());
        rig.world().setInternalTickCallback(callbackThatChainsOn, &application, preTick);
    }
    const WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain());
    rig.bullet().step(0.1, 10);
    EXPECT_EQ(callsBefore, 10);
    EXPECT_EQ(application.calls, 10);
}

TEST(PreTick, ACallbackThatWasWithdrawnIsNotCalled) {
    test::SheetWorld rig(test::smallSheet);
    Application application;
    rig.world().setInternalTickCallback(applicationCallback, &application, preTick);
    std::optional<WetCloth> cloth(std::in_place, rig.world(), rig.sheet(), fabrics::cottonPlain());
    cloth.reset();
    rig.world().setInternalTickCallback(nullptr, &application, preTick);
    cloth.emplace(rig.world(), rig.sheet(), fabrics::cottonPlain());
    cloth->soakFilm(0.1);
    rig.bullet().step(0.1, 10);
    EXPECT_EQ(application.calls, 0);
    EXPECT_GT(cloth->moisture().totalPoreMass(), 0.0);
}

// A world, a second one in its place of memory, and a sheet in either.
struct OneAddress {
    std::optional<demo::BulletWorld> world = std::nullopt;
    std::unique_ptr<btSoftBody> sheet;
    std::unique_ptr<WetCloth> cloth;

    OneAddress() { begin(); }
    ~OneAddress() {
        if (sheet->getBroadphaseHandle()) world->world().removeSoftBody(sheet.get());
    }
    OneAddress(const OneAddress&) = delete;
    OneAddress& operator=(const OneAddress&) = delete;

    void begin() {
        world.emplace();
        sheet = test::smallSheet(world->world().getWorldInfo());
        world->world().addSoftBody(sheet.get());
    }
    void cover() {
        cloth = std::make_unique<WetCloth>(world->world(), *sheet, fabrics::cottonPlain());
        cloth->soakFilm(0.1);
    }
};

TEST(PreTick, AWorldInThePlaceOfAnotherHasNoneOfItsCallbacks) {
    OneAddress rig;
    const btDynamicsWorld* const address = &rig.world->world();
    Application application;
    callsBefore = 0;
    rig.world->world().setInternalTickCallback(applicationCallback, &application, preTick);
    rig.cover();
    callbackFoundInTheSlot = Slot::of(rig.world->world());
    rig.cloth.reset();
    rig.begin();
    ASSERT_EQ(&rig.world->world(), address);
    rig.world->world().setInternalTickCallback(callbackThatChainsOn, &application, preTick);
    rig.world->step(0.1, 10);
    EXPECT_EQ(callsBefore, 10);
    EXPECT_EQ(application.calls, 0);
    rig.cover();
    rig.world->step(0.1, 10);
    EXPECT_EQ(callsBefore, 20);
    EXPECT_EQ(application.calls, 0);
    EXPECT_GT(rig.cloth->moisture().totalPoreMass(), 0.0);
}

TEST(PreTick, ALayerWhoseWorldIsGoneHearsNothingOfOneInItsPlace) {
    OneAddress rig;
    rig.cover();
    const btDynamicsWorld* const address = &rig.world->world();
    const std::unique_ptr<btSoftBody> oldSheet = std::move(rig.sheet);
    std::unique_ptr<WetCloth> oldCloth = std::move(rig.cloth);
    rig.begin();
    ASSERT_EQ(&rig.world->world(), address);
    oldSheet->m_worldInfo = &rig.world->world().getWorldInfo();
    rig.world->world().addSoftBody(oldSheet.get());
    rig.cover();
    rig.world->step(0.1, 10);
    EXPECT_EQ(oldCloth->moisture().totalPoreMass(), 0.0);
    const double before = rig.cloth->moisture().totalPoreMass();
    EXPECT_GT(before, 0.0);
    oldCloth.reset();
    rig.world->step(0.1, 10);
    EXPECT_GT(rig.cloth->moisture().totalPoreMass(), before);
    rig.world->world().removeSoftBody(oldSheet.get());
}

std::unique_ptr<WetCloth>* clothToEnd = nullptr;

void callbackThatEndsTheLayer(btDynamicsWorld*, btScalar) {
    clothToEnd->reset();
}

TEST(PreTick, ALayerMayEndWithinTheApplicationsCallback) {
    test::SheetWorld rig(test::smallSheet);
    rig.world().setInternalTickCallback(callbackThatEndsTheLayer, nullptr, preTick);
    auto cloth = std::make_unique<WetCloth>(rig.world(), rig.sheet(), fabrics::cottonPlain());
    clothToEnd = &cloth;
    rig.bullet().step(0.1, 10);
    EXPECT_EQ(cloth, nullptr);
    EXPECT_TRUE(test::isFinite(rig.sheet()));
}

// The three things whose order of ending is free. Each ends once.
struct Ending {
    std::unique_ptr<demo::BulletWorld> world = std::make_unique<demo::BulletWorld>();
    std::unique_ptr<btSoftBody> body = test::smallSheet(world->world().getWorldInfo());
    std::unique_ptr<WetCloth> cloth;
    std::vector<double> fields;
    const btCollisionShape* shape = nullptr;

    Ending() {
        body->m_cfg.kDG = btScalar(0.01);
        world->world().addSoftBody(body.get());
        body->updateConstants();  // as Bullet does in its next step
        fields = test::changedFields(*body);
        shape = body->getCollisionShape();
        cloth = std::make_unique<WetCloth>(world->world(), *body, fabrics::cottonPlain());
        cloth->air().vapourExchange = 0;
        cloth->soakFilm(0.1);
        world->step(0.05, 10);
        EXPECT_NE(test::changedFields(*body), fields);
        EXPECT_NE(body->getCollisionShape(), shape);
    }
    ~Ending() {
        if (world && body && body->getBroadphaseHandle()) removeBody();
    }
    Ending(const Ending&) = delete;
    Ending& operator=(const Ending&) = delete;
    void removeBody() { world->world().removeSoftBody(body.get()); }
    void expectBodyAsItWas() const {
        EXPECT_EQ(test::changedFields(*body), fields);
        EXPECT_EQ(body->getCollisionShape(), shape);
    }
};

TEST(Lifetime, ClothThenBodyThenWorld) {
    Ending end;
    end.cloth.reset();
    end.expectBodyAsItWas();
    end.world->step(0.05, 5);
    EXPECT_TRUE(test::isFinite(*end.body));
    end.removeBody();
    end.body.reset();
    end.world.reset();
}

TEST(Lifetime, ClothThenWorldThenBody) {
    Ending end;
    end.cloth.reset();
    end.world.reset();
    end.expectBodyAsItWas();
    end.body.reset();
}

TEST(Lifetime, BodyThenClothThenWorld) {
    Ending end;
    end.removeBody();
    end.body.reset();
    end.world->step(0.05, 5);  // the layer has nothing to do, and knows it
    EXPECT_NEAR(end.cloth->waterMass(), 0.025, 1e-8);
    EXPECT_THROW(end.cloth->addWater(0, -1), std::invalid_argument);
    end.cloth->addWater(0, 1e-4);
    end.cloth.reset();
    end.world->step(0.05, 5);
    end.world.reset();
}

TEST(Lifetime, BodyThenWorldThenCloth) {
    Ending end;
    end.removeBody();
    end.body.reset();
    end.world.reset();
    EXPECT_NEAR(end.cloth->waterMass(), 0.025, 1e-8);
    end.cloth.reset();
}

TEST(Lifetime, WorldThenBodyThenCloth) {
    Ending end;
    end.world.reset();
    EXPECT_NEAR(end.cloth->waterMass(), 0.025, 1e-8);
    end.body.reset();
    end.cloth->addWater(0, 1e-4);
    EXPECT_NEAR(end.cloth->waterMass(), 0.0251, 1e-8);
    end.cloth.reset();
}

TEST(Lifetime, WorldThenClothThenBody) {
    Ending end;
    end.world.reset();
    end.cloth.reset();
    end.expectBodyAsItWas();
    end.body.reset();
}

TEST(Lifetime, ABodyThatLeavesAndComesBackGoesOn) {
    Ending end;
    const double before = end.cloth->moisture().totalPoreMass();
    end.removeBody();
    end.world->step(0.1, 10);
    EXPECT_EQ(end.cloth->moisture().totalPoreMass(), before);
    end.world->world().addSoftBody(end.body.get());
    end.world->step(0.1, 10);
    EXPECT_GT(end.cloth->moisture().totalPoreMass(), before);
    end.removeBody();
}

TEST(Lifetime, ABodyInAnotherWorldIsNotSteppedByItsOld) {
    Ending end;
    demo::BulletWorld other;
    end.removeBody();
    end.body->m_worldInfo = &other.world().getWorldInfo();
    other.world().addSoftBody(end.body.get());
    const double before = end.cloth->moisture().totalPoreMass();
    end.world->step(0.1, 10);
    other.step(0.1, 10);
    EXPECT_EQ(end.cloth->moisture().totalPoreMass(), before);
    end.world.reset();
    end.cloth.reset();  // the body's world lives, the layer's does not
    other.step(0.1, 10);
    other.world().removeSoftBody(end.body.get());
}

// Ends after every static object of the library's, and says so.
struct LastThing {
    ~LastThing() {
        if (!ending) return;
        ending.reset();
        std::fputs("all has ended", stderr);
    }
    std::unique_ptr<Ending> ending;
};
LastThing endsWithTheProgram;

TEST(LifetimeDeathTest, ALayerMayEndWithTheProgram) {
    const auto run = [] {
        endsWithTheProgram.ending = std::make_unique<Ending>();
        std::exit(0);
    };
    EXPECT_EXIT(run(), testing::ExitedWithCode(0), "all has ended");
}

TEST(Lifetime, AWorldThatOutlivesAnUnhookedLayerStillCallsTheApplication) {
    Ending end;
    Application application;
    end.cloth.reset();
    end.world->world().setInternalTickCallback(applicationCallback, &application, preTick);
    end.cloth = std::make_unique<WetCloth>(end.world->world(), *end.body, fabrics::cottonPlain());
    end.removeBody();
    end.body.reset();
    end.cloth.reset();  // cannot tell whether the world is still there, and must not touch it
    end.world->step(0.05, 5);
    EXPECT_EQ(application.calls, 5);
}

}  // namespace
}  // namespace drench::lifetime_test
