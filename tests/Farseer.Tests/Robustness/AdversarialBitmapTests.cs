using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Farseer.Tests.Shared.Growth;
using FarseerGames.FarseerPhysics.Collisions;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>Bitmaps that are as hard as they can be: their polygons are simple, cover the pixels, and come in little time.</summary>
public class AdversarialBitmapTests
{
    /// <summary>Some 0.2 s for the slowest; what looks at all pixels for each island took a minute.</summary>
    private const double Patience = 10;

    private static readonly Dictionary<string, Func<int, int, int, bool>> _bitmaps = new(StringComparer.Ordinal)
    {
        ["nothing"] = (_, _, _) => false,
        ["everything"] = (_, _, _) => true,
        ["a chessboard"] = (x, y, _) => (x + y) % 2 == 0,
        ["dust"] = (x, y, _) => x % 2 == 0 && y % 2 == 0,
        ["a sieve"] = (x, y, _) => x % 2 == 0 || y % 2 == 0,
        ["a chessboard of holes"] = (x, y, _) => x % 4 < 2 || y % 4 < 2 || (x + y) % 2 == 0,
        ["a comb"] = (x, y, _) => x % 2 == 0 || y == 0,
        ["a comb on its side"] = (x, y, _) => y % 2 == 0 || x == 0,
        ["a snake"] = (x, y, side) => y % 2 == 0 || x == (y % 4 == 1 ? side - 1 : 0),
        ["rings in rings"] = (x, y, side) => Math.Min(Math.Min(x, y), side - 1 - Math.Max(x, y)) % 2 == 0,
        ["stairs"] = (x, y, _) => x <= y,
        ["a frame of one pixel"] = (x, y, side) => x == 0 || y == 0 || x == side - 1 || y == side - 1,
    };

    public static TheoryData<string> Bitmaps => new(_bitmaps.Keys);

    [Theory]
    [MemberData(nameof(Bitmaps))]
    public void CreatePolygons_OfAHardBitmap_AreSimpleAndCoverThePixels(string name)
    {
        foreach (int side in new[] { 1, 2, 3, 8, 33, 130 })
        {
            uint[] bits = new uint[side * side];
            for (int i = 0; i < bits.Length; i++)
            {
                bits[i] = _bitmaps[name](i % side, i / side, side) ? 0xFF000000 : 0;
            }

            foreach (float tolerance in new[] { 0, 0.4f, 2, 1e6f })
            {
                double start = GrowthClock.Seconds();

                List<Vertices> polygons = Vertices.CreatePolygons(bits, side, side, Vector2.Zero, 20, tolerance);

                Assert.InRange(GrowthClock.Seconds() - start, 0, Patience);
                Assert.All(polygons, p => Assert.True(p.IsSimple(), $"{name}, {side}, {tolerance}"));
                double pixels = bits.Count(b => b != 0);
                if (tolerance == 0)
                {
                    // A thirtieth of a pixel goes, or comes, at each corner where pixels touch diagonally: two of a pixel at most.
                    Assert.InRange(polygons.Sum(p => (double)p.GetArea()), pixels * (1 - 0.0625), pixels * (1 + 0.0625));
                }
            }
        }
    }
}
