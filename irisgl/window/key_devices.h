// The devices of the keys of letters and digits, in their order.
#pragma once

#include "irisgl/include/gl/device.h"

namespace gw::irisgl {

inline constexpr unsigned letter_keys[] = {AKEY, BKEY, CKEY, DKEY, EKEY, FKEY, GKEY, HKEY, IKEY,
                                           JKEY, KKEY, LKEY, MKEY, NKEY, OKEY, PKEY, QKEY, RKEY,
                                           SKEY, TKEY, UKEY, VKEY, WKEY, XKEY, YKEY, ZKEY};
inline constexpr unsigned digit_keys[] = {ZEROKEY, ONEKEY, TWOKEY,   THREEKEY, FOURKEY,
                                          FIVEKEY, SIXKEY, SEVENKEY, EIGHTKEY, NINEKEY};

}  // namespace gw::irisgl
