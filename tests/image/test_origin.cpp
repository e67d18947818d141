// Claim: a file says by which command it was written, and its bytes do not.
#include "image/output/origin.h"
#include "image/output/output_file.h"

#include "tests/image/files.h"

namespace gw::image {

class Origin : public testing::Test {
protected:
    void SetUp() override {
        set_origin("gw render 'a b' -o c");
        write_file(folder / "c", "bytes");
        if (!folder.keeps_attributes())
            GTEST_SKIP() << "no extended attributes in " << folder.path();
    }
    ~Origin() override { set_origin(""); }

    Folder folder;
};

TEST_F(Origin, IsBesideTheBytes) {
    EXPECT_EQ(origin_of(folder / "c"), "gw render 'a b' -o c");
    EXPECT_EQ(bytes_of(folder / "c"), "bytes");
    EXPECT_EQ(origin_of(folder / "none"), "");
}

TEST_F(Origin, IsOfTheCommandThatWroteLast) {
    set_origin("gw diff");
    write_file(folder / "c", "others");
    EXPECT_EQ(origin_of(folder / "c"), "gw diff");
    set_origin("");
    write_file(folder / "c", "nobody's");
    EXPECT_EQ(origin_of(folder / "c"), "");
}

TEST_F(Origin, ThatCannotBeNotedIsNoError) {
    set_origin(std::string(1 << 20, 'x'));
    EXPECT_NO_THROW(write_file(folder / "c", "whole"));
    EXPECT_EQ(bytes_of(folder / "c"), "whole");
    EXPECT_EQ(origin_of(folder / "c"), "");
}

}  // namespace gw::image
