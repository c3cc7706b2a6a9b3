// The ready-made fabrics. One line per value, with its provenance.
//
// Sources by short name:
//   Morton & Hearle 2008   Physical Properties of Textile Fibres, 4th ed.
//   Penava 2014            construction of plain weaves
//   Matsudaira 2015        KES bending and drape of broadcloth and tropical
//   Wang 2011              data-driven elastic models for cloth: stretch and shear
#include <algorithm>
#include <cmath>

#include "checks/checks.h"
#include "cloth/constants.h"
#include "drench/fabric.h"

namespace drench {

namespace {

Quantity measured(double value, const char* source) {
    return {value, Provenance::measured, source};
}
Quantity assumed(double value, const char* source = "") {
    return {value, Provenance::assumed, source};
}
Quantity textbook(double value, const char* source) {
    return {value, Provenance::textbook, source};
}

constexpr const char* mortonHearle = "Morton & Hearle 2008";
constexpr const char* penava = "Penava 2014";
constexpr const char* matsudaira = "Matsudaira et al. 2015";
constexpr const char* wang = "Wang et al. 2011";
constexpr const char* publishedRange = "middle of a published range";
constexpr const char* unrecorded = "published, but by whom is not on record";

// The scattering of a fibre is proportional to its Fresnel reflectance, which is lower in water than in air.
constexpr const char* fresnel = "Fresnel reflectance of the fibre in air over that in water";

constexpr const char* likeShirting = "usual for a smooth weave in KES compression tests";

// The entry pressure follows from that of cotton, 1200 Pa at a contact angle of 41 degrees, by the
// Young-Laplace equation. The permeability follows from the assumed product of the two, relative to cotton.
void setWicking(Fabric& fabric, double contactAngle, double productRelativeToCotton) {
    constexpr double cottonAngle = 41, cottonPressure = 1200, cottonPermeability = 2e-11;
    constexpr double degree = pi / 180;
    const double pressureRatio = std::cos(contactAngle * degree) / std::cos(cottonAngle * degree);
    const double permeability = cottonPermeability * productRelativeToCotton / pressureRatio;
    fabric.contactAngle = assumed(contactAngle);
    fabric.entryPressure =
        textbook(cottonPressure * pressureRatio, "Young-Laplace, from an assumed 1200 Pa for cotton");
    fabric.permeabilityWarp = assumed(permeability, "chosen together with the entry pressure");
    fabric.permeabilityWeft = fabric.permeabilityWarp;
    fabric.poreSizeIndex = assumed(1, "diffusivity ~ s^3, the measured kind");
    constexpr double throughOverAlong = 0.1;  // of bundles of fibres, across over along them
    fabric.permeabilityThrough =
        assumed(throughOverAlong * permeability, "a tenth of that along the cloth, as of bundles of fibres");
}

struct Friction {
    double dry, damp, soaked;
};

void setFriction(Fabric& fabric, Friction plate, Friction skin) {
    fabric.plateFrictionDry = assumed(plate.dry);
    fabric.plateFrictionDamp = assumed(plate.damp);
    fabric.plateFrictionSoaked = assumed(plate.soaked);
    fabric.skinFrictionDry = assumed(skin.dry, publishedRange);
    fabric.skinFrictionDamp = assumed(skin.damp, publishedRange);
    fabric.skinFrictionSoaked = assumed(skin.soaked, publishedRange);
}

void setAlbedo(Fabric& fabric, double red, double green, double blue) {
    fabric.albedoRed = assumed(red, "a colour to look at");
    fabric.albedoGreen = assumed(green, "a colour to look at");
    fabric.albedoBlue = assumed(blue, "a colour to look at");
}

void setLooks(Fabric& fabric, double threadSpacing, double scattering) {
    fabric.threadSpacing = assumed(threadSpacing, "usual for a cloth of this weight");
    fabric.scattering = assumed(scattering, "lets as much light through as such a cloth seems to");
}

}  // namespace

Fabric::Fabric() {
    arealDensity = measured(0.150, penava);
    thickness = measured(0.318e-3, penava);
    fibreDensity = measured(1520, mortonHearle);
    regain = measured(0.075, mortonHearle);
    boundMaximum = measured(0.22, mortonHearle);
    wettingTime = assumed(2, "a drop is gone within the 5 s of AATCC 79");
    setWicking(*this, 41, 1);
    stretchWarp = measured(2000, wang);
    stretchWeft = measured(2000, wang);
    shear = assumed(60);
    bending = measured(1.16e-5, matsudaira);
    bendingFriction = measured(6e-4, matsudaira);
    wetStretchRatio = assumed(0.6);
    wetBendingRatio = assumed(0.6);
    wetBendingFrictionRatio = assumed(1.7);
    setFriction(*this, {0.25, 0.9, 0.4}, {0.45, 1.2, 0.9});
    clingEnergy = assumed(0.13, "below the textbook bound of 0.146 J/m2");
    airPermeabilityDry = assumed(0.100);
    airPermeabilitySaturated = assumed(0.005);
    setAlbedo(*this, 0.20, 0.31, 0.46);
    setLooks(*this, 3.5e-4, 6);
    scatteringLoss = textbook(8, fresnel);
    pressedThicknessRatio = assumed(0.75, likeShirting);
}

namespace fabrics {

Fabric cottonPlain() {
    return Fabric();
}

Fabric polyesterPlain() {
    Fabric fabric;
    fabric.name = "polyester plain";
    fabric.arealDensity = measured(0.120, penava);
    fabric.thickness = measured(0.25e-3, penava);
    fabric.fibreDensity = measured(1390, mortonHearle);
    fabric.regain = measured(0.004, mortonHearle);
    fabric.boundMaximum = assumed(0.02);
    fabric.wettingTime = assumed(20);
    setWicking(fabric, 75, 0.15);
    fabric.stretchWarp = measured(2000, wang);
    fabric.stretchWeft = measured(2000, wang);
    fabric.shear = measured(20, wang);
    fabric.bending = measured(4e-6, matsudaira);
    fabric.bendingFriction = measured(1e-4, matsudaira);
    fabric.wetStretchRatio = assumed(1.0);
    fabric.wetBendingRatio = assumed(0.9, unrecorded);
    fabric.wetBendingFrictionRatio = assumed(0.8, unrecorded);
    setFriction(fabric, {0.2, 0.6, 0.3}, {0.40, 0.9, 0.7});
    fabric.clingEnergy = assumed(0.09);
    fabric.airPermeabilityDry = assumed(0.100);
    fabric.airPermeabilitySaturated = assumed(0.020);
    setAlbedo(fabric, 0.56, 0.60, 0.62);
    setLooks(fabric, 3.0e-4, 5);
    fabric.scatteringLoss = textbook(6, fresnel);
    fabric.pressedThicknessRatio = assumed(0.75, likeShirting);
    return fabric;
}

Fabric polyesterTropical() {
    constexpr const char* likePlain = "as polyester plain";
    Fabric fabric = polyesterPlain();
    // Only values measured on this very cloth are marked as measured.
    for (const FabricParameter& parameter : fabricParameters()) {
        Quantity& quantity = fabric.*parameter.member;
        if (quantity.provenance != Provenance::textbook) quantity = assumed(quantity, likePlain);
    }
    fabric.name = "polyester tropical";
    fabric.arealDensity = measured(0.1165, matsudaira);
    fabric.thickness = measured(0.340e-3, matsudaira);
    fabric.fibreDensity = measured(1390, mortonHearle);
    fabric.regain = measured(0.004, mortonHearle);
    fabric.bending = measured(7.55e-6, matsudaira);
    fabric.bendingFriction = measured(1.42e-4, matsudaira);
    setLooks(fabric, 5.0e-4, 4);
    return fabric;
}

Fabric wool() {
    Fabric fabric;
    fabric.name = "wool";
    fabric.arealDensity = assumed(0.200, unrecorded);
    fabric.thickness = assumed(0.50e-3, unrecorded);
    fabric.fibreDensity = measured(1310, mortonHearle);
    fabric.regain = measured(0.15, mortonHearle);
    fabric.boundMaximum = assumed(0.33);
    fabric.wettingTime = assumed(60);
    setWicking(fabric, 85, 0.015);
    fabric.stretchWarp = assumed(800);
    fabric.stretchWeft = assumed(800);
    fabric.shear = assumed(30);
    fabric.bending = measured(6.6e-6, matsudaira);
    fabric.bendingFriction = measured(1.6e-4, matsudaira);
    fabric.wetStretchRatio = assumed(0.6);
    fabric.wetBendingRatio = assumed(1.1, unrecorded);
    fabric.wetBendingFrictionRatio = assumed(2.0);
    setFriction(fabric, {0.3, 0.8, 0.4}, {0.45, 1.0, 0.8});
    fabric.clingEnergy = assumed(0.07);
    fabric.airPermeabilityDry = assumed(0.300);
    fabric.airPermeabilitySaturated = assumed(0.060);
    setAlbedo(fabric, 0.30, 0.28, 0.27);
    setLooks(fabric, 6.0e-4, 9);
    fabric.scatteringLoss = textbook(8, fresnel);
    fabric.pressedThicknessRatio = assumed(0.7, "softer than a smooth weave");
    return fabric;
}

Fabric linen() {
    Fabric fabric;
    fabric.name = "linen";
    fabric.arealDensity = assumed(0.180);
    fabric.thickness = assumed(0.38e-3);
    fabric.fibreDensity = assumed(1500);
    fabric.regain = measured(0.09, mortonHearle);
    fabric.boundMaximum = assumed(0.25);
    fabric.wettingTime = assumed(1.5);
    setWicking(fabric, 35, 1.5);
    fabric.stretchWarp = assumed(4000);
    fabric.stretchWeft = assumed(4000);
    fabric.shear = assumed(60);
    fabric.bending = assumed(2e-5);
    fabric.bendingFriction = assumed(8e-4);
    fabric.wetStretchRatio = assumed(0.7);
    fabric.wetBendingRatio = assumed(0.7);
    fabric.wetBendingFrictionRatio = assumed(1.5);
    setFriction(fabric, {0.25, 0.9, 0.4}, {0.45, 1.2, 0.9});
    fabric.clingEnergy = assumed(0.13);
    fabric.airPermeabilityDry = assumed(0.150);
    fabric.airPermeabilitySaturated = assumed(0.005);
    setAlbedo(fabric, 0.55, 0.48, 0.36);
    setLooks(fabric, 6.0e-4, 6);
    fabric.scatteringLoss = textbook(8, fresnel);
    fabric.pressedThicknessRatio = assumed(0.8, "stiffer yarns than of cotton");
    return fabric;
}

Fabric silk() {
    Fabric fabric;
    fabric.name = "silk";
    fabric.arealDensity = assumed(0.070);
    fabric.thickness = assumed(0.15e-3);
    fabric.fibreDensity = measured(1340, mortonHearle);
    fabric.regain = measured(0.10, mortonHearle);
    fabric.boundMaximum = assumed(0.30);
    fabric.wettingTime = assumed(3);
    setWicking(fabric, 55, 0.75);
    fabric.stretchWarp = assumed(1500);
    fabric.stretchWeft = assumed(1500);
    fabric.shear = assumed(20);
    fabric.bending = assumed(3e-6);
    fabric.bendingFriction = assumed(1e-4);
    fabric.wetStretchRatio = assumed(0.5);
    fabric.wetBendingRatio = assumed(0.5);
    fabric.wetBendingFrictionRatio = assumed(1.3);
    setFriction(fabric, {0.2, 0.7, 0.3}, {0.35, 0.9, 0.7});
    fabric.clingEnergy = assumed(0.11);
    fabric.airPermeabilityDry = assumed(0.150);
    fabric.airPermeabilitySaturated = assumed(0.010);
    setAlbedo(fabric, 0.55, 0.16, 0.20);
    setLooks(fabric, 2.2e-4, 2.5);
    fabric.scatteringLoss = textbook(7.6, fresnel);
    fabric.pressedThicknessRatio = assumed(0.75, likeShirting);
    return fabric;
}

Fabric nylonTaffeta() {
    Fabric fabric;
    fabric.name = "nylon taffeta";
    fabric.arealDensity = assumed(0.070);
    fabric.thickness = assumed(0.12e-3);
    fabric.fibreDensity = measured(1140, mortonHearle);
    fabric.regain = measured(0.042, mortonHearle);
    fabric.boundMaximum = assumed(0.08);
    fabric.wettingTime = assumed(20);
    setWicking(fabric, 67, 0.2);
    fabric.stretchWarp = assumed(1500);
    fabric.stretchWeft = assumed(1500);
    fabric.shear = assumed(25);
    fabric.bending = assumed(3e-6);
    fabric.bendingFriction = assumed(1e-4);
    fabric.wetStretchRatio = assumed(0.85);
    fabric.wetBendingRatio = assumed(0.85);
    fabric.wetBendingFrictionRatio = assumed(1.0);
    setFriction(fabric, {0.2, 0.6, 0.3}, {0.40, 0.9, 0.7});
    fabric.clingEnergy = assumed(0.10);
    fabric.airPermeabilityDry = assumed(0.030);
    fabric.airPermeabilitySaturated = assumed(0.002);
    setAlbedo(fabric, 0.70, 0.30, 0.08);
    setLooks(fabric, 1.8e-4, 2.5);
    fabric.scatteringLoss = textbook(8.5, fresnel);
    fabric.pressedThicknessRatio = assumed(0.8, "dense and flat");
    return fabric;
}

Fabric denim() {
    Fabric fabric;
    fabric.name = "denim 11 oz";
    fabric.arealDensity = assumed(0.324, unrecorded);
    fabric.thickness = assumed(0.70e-3);
    fabric.fibreDensity = measured(1520, mortonHearle);
    fabric.regain = measured(0.075, mortonHearle);
    fabric.boundMaximum = measured(0.22, mortonHearle);
    fabric.wettingTime = assumed(6);
    setWicking(fabric, 41, 0.5);
    fabric.stretchWarp = measured(205, wang);
    fabric.stretchWeft = measured(1014, wang);
    fabric.shear = measured(53, wang);
    fabric.bending = measured(7e-5, matsudaira);
    fabric.bendingFriction = assumed(2e-3);
    fabric.wetStretchRatio = assumed(0.6);
    fabric.wetBendingRatio = assumed(0.7);
    fabric.wetBendingFrictionRatio = assumed(1.7);
    setFriction(fabric, {0.3, 0.9, 0.4}, {0.5, 1.1, 0.9});
    fabric.clingEnergy = assumed(0.10);
    fabric.airPermeabilityDry = assumed(0.030);
    fabric.airPermeabilitySaturated = assumed(0.001);
    setAlbedo(fabric, 0.09, 0.14, 0.26);
    setLooks(fabric, 7.0e-4, 16);
    fabric.construction = Construction::twill;
    fabric.scatteringLoss = textbook(8, fresnel);
    fabric.pressedThicknessRatio = assumed(0.6, "KES compression of other denims, 0.54 to 0.68");
    return fabric;
}

Fabric jersey() {
    constexpr const char* softKnit = "a knit gives way by bending its loops";
    Fabric fabric;
    fabric.name = "cotton jersey";
    fabric.arealDensity = assumed(0.160);
    fabric.thickness = assumed(0.55e-3);
    fabric.fibreDensity = measured(1520, mortonHearle);
    fabric.construction = Construction::knit;
    fabric.regain = measured(0.075, mortonHearle);
    fabric.boundMaximum = measured(0.22, mortonHearle);
    fabric.wettingTime = assumed(2);
    setWicking(fabric, 41, 1.5);
    fabric.stretchWarp = assumed(150, softKnit);
    fabric.stretchWeft = assumed(80, softKnit);
    fabric.shear = assumed(30, softKnit);
    fabric.bending = assumed(2e-6);
    fabric.bendingFriction = assumed(1e-4);
    fabric.wetStretchRatio = assumed(0.7);
    fabric.wetBendingRatio = assumed(0.6);
    fabric.wetBendingFrictionRatio = assumed(1.7);
    setFriction(fabric, {0.25, 0.9, 0.4}, {0.45, 1.2, 0.9});
    fabric.clingEnergy = assumed(0.12);
    fabric.airPermeabilityDry = assumed(0.800);
    fabric.airPermeabilitySaturated = assumed(0.020);
    setAlbedo(fabric, 0.62, 0.60, 0.55);
    setLooks(fabric, 9.0e-4, 5);
    fabric.scatteringLoss = textbook(8, fresnel);
    fabric.pressedThicknessRatio = assumed(0.6, "a knit gives way");
    return fabric;
}

namespace {

struct Preset {
    const char* name;
    Fabric (*make)();
};

constexpr Preset presets[] = {{"cotton", cottonPlain},
                              {"polyester", polyesterPlain},
                              {"tropical", polyesterTropical},
                              {"wool", wool},
                              {"linen", linen},
                              {"silk", silk},
                              {"nylon", nylonTaffeta},
                              {"denim", denim},
                              {"jersey", jersey}};

}  // namespace

const std::vector<std::string>& names() {
    static const std::vector<std::string> all = [] {
        std::vector<std::string> list;
        for (const Preset& preset : presets) list.emplace_back(preset.name);
        return list;
    }();
    return all;
}

Fabric byName(std::string_view name) {
    for (const Preset& preset : presets)
        if (name == preset.name) return preset.make();
    std::string known;
    for (const Preset& preset : presets) known += (known.empty() ? "" : ", ") + std::string(preset.name);
    refuse("no fabric named ", inQuotes(name), "; there are ", known);
}

}  // namespace fabrics
}  // namespace drench
