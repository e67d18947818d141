// Lights in RGB and in colour map mode: closed forms, and OpenGL's own picture.
#include "tests/irisgl/support.h"

#include <GL/gl.h>

#include <vector>

namespace gw::irisgl {

class IrisGlLighting : public IrisGl {
protected:
    void SetUp() override {
        IrisGl::SetUp();
        forget();
        RGBmode();
        mmode(MVIEWING);
        const float one[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
        loadmatrix(const_cast<float(*)[4]>(one));
        ortho(-1, 1, -1, 1, -10, 10);
        cpack(0);
        clear();
    }
    void TearDown() override {
        for (const short target : {MATERIAL, LMODEL, LIGHT0}) lmbind(target, 0);
        IrisGl::TearDown();
    }
    static void define(short kind, std::vector<float> words) {
        lmdef(kind, 1, short(words.size()), words.data());
    }
    /// Nothing is left of what another test defined.
    static void forget() {
        for (const short kind : {DEFMATERIAL, DEFLMODEL, DEFLIGHT}) define(kind, {LMNULL});
    }
    static void bind() {
        for (const short target : {MATERIAL, LMODEL, LIGHT0}) lmbind(target, 1);
    }
    static void square() {
        const float v[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        const float n[3] = {0, 0, 1};
        n3f(const_cast<float*>(n));
        bgnpolygon();
        for (const auto& at : v) v2f(const_cast<float*>(at));
        endpolygon();
    }
};

// ambient 0.2 x 0.5, and diffuse 0.6 x 1 x cos 60 degrees: 0.4 of 255 in R.
TEST_F(IrisGlLighting, AmbientAndDiffuseLightAddUp) {
    define(DEFMATERIAL, {AMBIENT, 0.2f, 0, 0, DIFFUSE, 0.6f, 0.4f, 0, LMNULL});
    define(DEFLMODEL, {AMBIENT, 0.5f, 0.5f, 0.5f, LMNULL});
    define(DEFLIGHT, {LCOLOR, 1, 1, 1, POSITION, 0.8660254f, 0, 0.5f, 0, LMNULL});
    bind();
    square();
    EXPECT_EQ(shown(8, 8), 102u | 51u << 8);
}

TEST_F(IrisGlLighting, ABoundLightMovesWhenItIsDefinedAnew) {
    define(DEFMATERIAL, {AMBIENT, 0, 0, 0, DIFFUSE, 1, 1, 1, LMNULL});
    define(DEFLMODEL, {AMBIENT, 0, 0, 0, LMNULL});
    define(DEFLIGHT, {POSITION, 0, 0, -1, 0, LMNULL});
    bind();
    square();
    EXPECT_EQ(shown(8, 8), 0u);
    define(DEFLIGHT, {POSITION, 0, 0, 1, 0, LMNULL});
    square();
    EXPECT_EQ(shown(8, 8), 0xFFFFFFu);
    // Another property keeps the place; another place is turned by the matrix of now.
    pushmatrix();
    rotate(1800, 'x');
    define(DEFLIGHT, {LCOLOR, 1, 0, 0, LMNULL});
    popmatrix();
    square();
    EXPECT_EQ(shown(8, 8), 0xFFu);
    pushmatrix();
    rotate(1800, 'x');
    define(DEFLIGHT, {POSITION, 0, 0, 1, 0, LMNULL});
    popmatrix();
    square();
    EXPECT_EQ(shown(8, 8), 0u);
}

TEST_F(IrisGlLighting, AttenuationOfTheModelDividesALocalLight) {
    define(DEFMATERIAL, {AMBIENT, 0, 0, 0, DIFFUSE, 1, 1, 1, LMNULL});
    define(DEFLMODEL, {AMBIENT, 0, 0, 0, ATTENUATION, 1, 2, LMNULL});
    define(DEFLIGHT, {POSITION, 0, 0, 2, 1, LMNULL});
    bind();
    const float n[3] = {0, 0, 1}, v[2] = {0.0625f, 0.0625f};
    n3f(const_cast<float*>(n));
    translate(-0.0625f, -0.0625f, 0);  // the light stood above the middle; so does the point
    bgnpoint();
    v2f(const_cast<float*>(v));
    endpoint();
    EXPECT_EQ(shown(8, 8) & 0xFF, 51u);  // 255 / (1 + 2 x 2)
}

TEST_F(IrisGlLighting, LmcolorPutsTheColourIntoTheMaterial) {
    define(DEFMATERIAL, {AMBIENT, 0, 0, 0, DIFFUSE, 1, 1, 1, LMNULL});
    define(DEFLMODEL, {AMBIENT, 0, 0, 0, LMNULL});
    define(DEFLIGHT, {POSITION, 0, 0, 1, 0, LMNULL});
    bind();
    lmcolor(LMC_DIFFUSE);
    RGBcolor(51, 102, 204);
    square();
    lmcolor(LMC_COLOR);
    EXPECT_EQ(shown(8, 8), 51u | 102u << 8 | 204u << 16);
}

TEST_F(IrisGlLighting, AColourAfterTheNormalTurnsLightOff) {
    define(DEFMATERIAL, {DIFFUSE, 1, 1, 1, LMNULL});
    define(DEFLMODEL, {AMBIENT, 0, 0, 0, LMNULL});
    define(DEFLIGHT, {POSITION, 0, 0, 1, 0, LMNULL});
    bind();
    const float n[3] = {0, 0, 1};
    n3f(const_cast<float*>(n));
    RGBcolor(10, 20, 30);
    rectf(-1, -1, 1, 1);
    EXPECT_EQ(shown(8, 8), 10u | 20u << 8 | 30u << 16);
}

// Ambient index 100, diffuse 200, specular 300. The light stands 60 degrees off: 100 + 0.5 x 100.
TEST_F(IrisGlLighting, IndicesGoFromTheAmbientToTheDiffuseOne) {
    cmode();
    define(DEFMATERIAL, {COLORINDEXES, 100, 200, 300, SHININESS, 0, LMNULL});
    define(DEFLMODEL, {AMBIENT, 0, 0, 0, LMNULL});
    define(DEFLIGHT, {LCOLOR, 1, 1, 1, POSITION, 0.8660254f, 0, 0.5f, 0, LMNULL});
    bind();
    square();
    EXPECT_EQ(index_at(8, 8), 150);
    define(DEFLIGHT, {POSITION, 0, 0, 1, 0, LMNULL});
    square();
    EXPECT_EQ(index_at(8, 8), 200);
    define(DEFMATERIAL, {SHININESS, 10, LMNULL});  // the reflection stands in the eye
    square();
    EXPECT_EQ(index_at(8, 8), 300);
}

// The same square by OpenGL's own calls in the same window.
TEST_F(IrisGlLighting, AShinyMaterialLooksAsThroughOpenGL) {
    subpixel(TRUE);
    define(DEFMATERIAL, {AMBIENT, 0.1f, 0.2f, 0.3f, DIFFUSE, 0.3f, 0.2f, 0.1f, SPECULAR, 0.5f, 0.6f,
                         0.7f, SHININESS, 8, EMISSION, 0.01f, 0.02f, 0.03f, LMNULL});
    define(DEFLMODEL, {AMBIENT, 0.3f, 0.3f, 0.3f, LOCALVIEWER, 1, LMNULL});
    define(DEFLIGHT, {LCOLOR, 1, 0.9f, 0.8f, POSITION, 0.5f, 0.25f, 2, 1, LMNULL});
    translate(0, 0, -3);
    bind();
    square();
    std::vector<std::uint32_t> ours;
    for (int i = 0; i < 256; ++i) ours.push_back(shown(i % 16, i / 16));
    cpack(0);
    clear();
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-1, 1, -1, 1, -10, 10);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -3);
    const float ambient[] = {0.1f, 0.2f, 0.3f, 1}, diffuse[] = {0.3f, 0.2f, 0.1f, 1},
                specular[] = {0.5f, 0.6f, 0.7f, 1}, emission[] = {0.01f, 0.02f, 0.03f, 1},
                model[] = {0.3f, 0.3f, 0.3f, 1}, light[] = {1, 0.9f, 0.8f, 1},
                place[] = {0.5f, 0.25f, 2, 1}, none[] = {0, 0, 0, 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, ambient);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, emission);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 8);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, model);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    glLightfv(GL_LIGHT0, GL_AMBIENT, none);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, light);
    glLightfv(GL_LIGHT0, GL_SPECULAR, light);
    glLightfv(GL_LIGHT0, GL_POSITION, place);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHTING);
    glBegin(GL_POLYGON);
    glNormal3f(0, 0, 1);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    glVertex2f(1, 1);
    glVertex2f(-1, 1);
    glEnd();
    glDisable(GL_LIGHTING);
    EXPECT_NE(ours[0], ours[200]);
    for (int i = 0; i < 256; ++i) EXPECT_EQ(shown(i % 16, i / 16), ours[std::size_t(i)]) << i;
}

}  // namespace gw::irisgl
