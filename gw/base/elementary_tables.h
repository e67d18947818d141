// Tables of gw/base/elementary.cpp, and no code. Each value is the sum hi + lo of two doubles;
// tests/gw/base/test_elementary_tables.cpp computes them again from their series, in integers.
#pragma once

#include "gw/base/exact_sum.h"

namespace gw::elementary {

// Multiples of 2^-42, so that k * ln2 + log_node is exact for |k| < 2^11; lo is the rest.
inline constexpr Sum ln2 = {0x1.62e42fefa38p-1, 0x1.ef35793c7673p-45};
inline constexpr Sum ln2_64th = {0x1.62e42fefap-7, 0x1.cf79abc9e3b3ap-46};  // ln 2 / 64

// pi/2 in parts of 33, 33, 33 and 53 bits: k times each of the first three is exact for |k| < 2^20.
inline constexpr double half_pi_parts[4] = {0x1.921fb544p0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69,
                                            0x1.b839a252049c1p-104};
inline constexpr Sum half_pi = {0x1.921fb54442d18p0, 0x1.1a62633145c07p-54};
inline constexpr Sum degree = {0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};  // pi / 180

// log(i / 64) for i = 45 .. 90: hi a multiple of 2^-42.
inline constexpr int first_log_node = 45;
inline constexpr Sum log_node[46] = {
    {-0x1.68ac83e9c7p-2, 0x1.7af966c548a3p-44},   {-0x1.522ae0738ap-2, -0x1.ebe708164c759p-45},
    {-0x1.3c25277333p-2, -0x1.83b54b606bd5cp-46}, {-0x1.269621134ep-2, 0x1.1b61f10522625p-44},
    {-0x1.1178e8227ep-2, -0x1.1ef78ce2d07f2p-44}, {-0x1.f991c6cb3cp-3, 0x1.90d04cd7cc834p-44},
    {-0x1.d1037f2656p-3, 0x1.84a7e75b6f6e4p-47},  {-0x1.a93ed3c8aep-3, 0x1.8724350562169p-45},
    {-0x1.823c16551ap-3, -0x1.e0ddb9a631e83p-46}, {-0x1.5bf406b544p-3, 0x1.27023eb68981cp-46},
    {-0x1.365fcb015ap-3, 0x1.fd3a0afb9691bp-44},  {-0x1.1178e8227ep-3, -0x1.1ef78ce2d07f2p-45},
    {-0x1.da72763844p-4, -0x1.a89401fa71733p-46}, {-0x1.9335e5d594p-4, -0x1.3115c3abd47dap-45},
    {-0x1.4d3115d208p-4, 0x1.53a2582f4e1efp-48},  {-0x1.08598b59e4p-4, 0x1.7e5dd7009902cp-46},
    {-0x1.894aa149f8p-5, -0x1.9a19a8be97661p-44}, {-0x1.0415d89e78p-5, 0x1.dddc7f461c516p-44},
    {-0x1.020565893p-6, -0x1.611d27c8e8417p-44},  {0x0p0, 0x0p0},
    {0x1.fc0a8b0fcp-7, 0x1.f1e7cf6d3a69cp-50},    {0x1.f829b0e78p-6, 0x1.980267c7e09e4p-45},
    {0x1.77458f633p-5, -0x1.181dce586af09p-44},   {0x1.f0a30c0118p-5, -0x1.d599e83368e91p-45},
    {0x1.341d7961bcp-4, 0x1.1d0929983761p-44},    {0x1.6f0d28ae58p-4, -0x1.4b4641b664613p-44},
    {0x1.a926d3a4acp-4, 0x1.563650bd22a9cp-44},   {0x1.e27076e2bp-4, -0x1.a342c2af0003cp-45},
    {0x1.0d77e7cd08p-3, 0x1.cb2cd2ee2f482p-44},   {0x1.29552f82p-3, -0x1.5b967f4471dfcp-44},
    {0x1.44d2b6ccb8p-3, -0x1.70cc16135783cp-46},  {0x1.5ff3070a7ap-3, -0x1.8586f183bebf2p-44},
    {0x1.7ab890210ep-3, -0x1.bdb9072534a58p-45},  {0x1.9525a9cf46p-3, -0x1.297137d9f158fp-44},
    {0x1.af3c94e80cp-3, -0x1.a4e633fcd9066p-52},  {0x1.c8ff7c79aap-3, -0x1.7794f689f8434p-45},
    {0x1.e27076e2bp-3, -0x1.a342c2af0003cp-44},   {0x1.fb9186d5e4p-3, -0x1.d572aab993c87p-47},
    {0x1.0a324e2739p-2, 0x1.c6bee7ef4030ep-47},   {0x1.1675cababap-2, 0x1.8380e731f55c4p-44},
    {0x1.22941fbcf8p-2, -0x1.a6976f5eb0963p-44},  {0x1.2e8e2bae12p-2, -0x1.67b1e99b72bd8p-45},
    {0x1.3a64c55694p-2, 0x1.7a71cbcd735dp-44},    {0x1.4618bc21c6p-2, -0x1.3d82f484c84ccp-46},
    {0x1.51aad872ep-2, -0x1.f4bd8db0a7cc1p-44},   {0x1.5d1bdbf581p-2, -0x1.8d6bdc9c7c238p-44},
};

// 2^(i / 64), i = 0 .. 63.
inline constexpr Sum exp2_node[64] = {
    {0x1p0, 0x0p0},
    {0x1.02c9a3e778061p0, -0x1.19083535b085dp-56},
    {0x1.059b0d3158574p0, 0x1.d73e2a475b465p-55},
    {0x1.0874518759bc8p0, 0x1.186be4bb284ffp-57},
    {0x1.0b5586cf9890fp0, 0x1.8a62e4adc610bp-54},
    {0x1.0e3ec32d3d1a2p0, 0x1.03a1727c57b53p-59},
    {0x1.11301d0125b51p0, -0x1.6c51039449b3ap-54},
    {0x1.1429aaea92dep0, -0x1.32fbf9af1369ep-54},
    {0x1.172b83c7d517bp0, -0x1.19041b9d78a76p-55},
    {0x1.1a35beb6fcb75p0, 0x1.e5b4c7b4968e4p-55},
    {0x1.1d4873168b9aap0, 0x1.e016e00a2643cp-54},
    {0x1.2063b88628cd6p0, 0x1.dc775814a8495p-55},
    {0x1.2387a6e756238p0, 0x1.9b07eb6c70573p-54},
    {0x1.26b4565e27cddp0, 0x1.2bd339940e9d9p-55},
    {0x1.29e9df51fdee1p0, 0x1.612e8afad1255p-55},
    {0x1.2d285a6e4030bp0, 0x1.0024754db41d5p-54},
    {0x1.306fe0a31b715p0, 0x1.6f46ad23182e4p-55},
    {0x1.33c08b26416ffp0, 0x1.32721843659a6p-54},
    {0x1.371a7373aa9cbp0, -0x1.63aeabf42eae2p-54},
    {0x1.3a7db34e59ff7p0, -0x1.5e436d661f5e3p-56},
    {0x1.3dea64c123422p0, 0x1.ada0911f09ebcp-55},
    {0x1.4160a21f72e2ap0, -0x1.ef3691c309278p-58},
    {0x1.44e086061892dp0, 0x1.89b7a04ef80dp-59},
    {0x1.486a2b5c13cdp0, 0x1.3c1a3b69062fp-56},
    {0x1.4bfdad5362a27p0, 0x1.d4397afec42e2p-56},
    {0x1.4f9b2769d2ca7p0, -0x1.4b309d25957e3p-54},
    {0x1.5342b569d4f82p0, -0x1.07abe1db13cadp-55},
    {0x1.56f4736b527dap0, 0x1.9bb2c011d93adp-54},
    {0x1.5ab07dd485429p0, 0x1.6324c054647adp-54},
    {0x1.5e76f15ad2148p0, 0x1.ba6f93080e65ep-54},
    {0x1.6247eb03a5585p0, -0x1.383c17e40b497p-54},
    {0x1.6623882552225p0, -0x1.bb60987591c34p-54},
    {0x1.6a09e667f3bcdp0, -0x1.bdd3413b26456p-54},
    {0x1.6dfb23c651a2fp0, -0x1.bbe3a683c88abp-57},
    {0x1.71f75e8ec5f74p0, -0x1.16e4786887a99p-55},
    {0x1.75feb564267c9p0, -0x1.0245957316dd3p-54},
    {0x1.7a11473eb0187p0, -0x1.41577ee04992fp-55},
    {0x1.7e2f336cf4e62p0, 0x1.05d02ba15797ep-56},
    {0x1.82589994cce13p0, -0x1.d4c1dd41532d8p-54},
    {0x1.868d99b4492edp0, -0x1.fc6f89bd4f6bap-54},
    {0x1.8ace5422aa0dbp0, 0x1.6e9f156864b27p-54},
    {0x1.8f1ae99157736p0, 0x1.5cc13a2e3976cp-55},
    {0x1.93737b0cdc5e5p0, -0x1.75fc781b57ebcp-57},
    {0x1.97d829fde4e5p0, -0x1.d185b7c1b85d1p-54},
    {0x1.9c49182a3f09p0, 0x1.c7c46b071f2bep-56},
    {0x1.a0c667b5de565p0, -0x1.359495d1cd533p-54},
    {0x1.a5503b23e255dp0, -0x1.d2f6edb8d41e1p-54},
    {0x1.a9e6b5579fdbfp0, 0x1.0fac90ef7fd31p-54},
    {0x1.ae89f995ad3adp0, 0x1.7a1cd345dcc81p-54},
    {0x1.b33a2b84f15fbp0, -0x1.2805e3084d708p-57},
    {0x1.b7f76f2fb5e47p0, -0x1.5584f7e54ac3bp-56},
    {0x1.bcc1e904bc1d2p0, 0x1.23dd07a2d9e84p-55},
    {0x1.c199bdd85529cp0, 0x1.11065895048ddp-55},
    {0x1.c67f12e57d14bp0, 0x1.2884dff483cadp-54},
    {0x1.cb720dcef9069p0, 0x1.503cbd1e949dbp-56},
    {0x1.d072d4a07897cp0, -0x1.cbc3743797a9cp-54},
    {0x1.d5818dcfba487p0, 0x1.2ed02d75b3707p-55},
    {0x1.da9e603db3285p0, 0x1.c2300696db532p-54},
    {0x1.dfc97337b9b5fp0, -0x1.1a5cd4f184b5cp-54},
    {0x1.e502ee78b3ff6p0, 0x1.39e8980a9cc8fp-55},
    {0x1.ea4afa2a490dap0, -0x1.e9c23179c2893p-54},
    {0x1.efa1bee615a27p0, 0x1.dc7f486a4b6bp-54},
    {0x1.f50765b6e454p0, 0x1.9d3e12dd8a18bp-54},
    {0x1.fa7c1819e90d8p0, 0x1.74853f3a5931ep-55},
};

// atan(i / 32), i = 0 .. 32.
inline constexpr Sum atan_node[33] = {
    {0x0p0, 0x0p0},
    {0x1.ffd55bba97625p-6, -0x1.5ec431444912cp-60},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.7ee182602f10fp-4, -0x1.cfb654c0c3d98p-58},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.3d6eee8c6626cp-3, 0x1.61a3b0ce9281bp-57},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
    {0x1.b90d7529260a2p-3, 0x1.17b10d2e0e5abp-61},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.18bf5a30bf178p-2, 0x1.30ca4748b1bf9p-57},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.530ad9951cd4ap-2, -0x1.2566480884082p-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.8b24d394a1b25p-2, 0x1.b6d0ba3748fa8p-56},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.c0db4c94ec9fp-2, -0x1.cc1ce70934c34p-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.f40dd0b541418p-2, -0x1.a3992dc382a23p-57},
    {0x1.0657e94db30dp-1, -0x1.d5b495f6349e6p-56},
    {0x1.1255d9bfbd2a9p-1, -0x1.2bdaee1c0ee35p-58},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.2958e59308e31p-1, -0x1.09e73b0c6c087p-56},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.3f13fb89e96f4p-1, 0x1.ecf8b492644fp-56},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.538f57b89061fp-1, -0x1.1bb74abda520cp-55},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.66d663923e087p-1, -0x1.6ea6febe8bbbap-56},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.78f6bbd5d315ep-1, 0x1.406a08980374p-55},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.89ff5ff57f1f8p-1, -0x1.55b9a5e177a1bp-55},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};

}  // namespace gw::elementary
