using System;
using System.Linq;
using FarseerGames.FarseerPhysics.Collisions;
using Xunit;

namespace Farseer.Porting.Tests
{
    /// <summary>Triangles to draw an outline with, as neighbouring versions have them.</summary>
    public sealed class TriangulationTests
    {
        [Fact]
        public void Triangles_OfAnyOutline_CoverItOnce_InTheOrderAskedFor()
        {
            for (int seed = 0; seed < 300; seed++)
            {
                Vector2[] outline = Star(new Random(seed));
                bool clockwise = seed % 2 == 0;
                Vertices.Triangulate(
                    outline,
                    clockwise ? Vertices.WindingOrder.Clockwise : Vertices.WindingOrder.CounterClockwise,
                    out Vector2[] corners,
                    out short[] indices);

                // n corners make n - 2 triangles; all of one sign, and together the whole area.
                Assert.Equal(3 * (corners.Length - 2), indices.Length);
                double sum = 0;
                for (int i = 0; i < indices.Length; i += 3)
                {
                    double area = Area(corners[indices[i]], corners[indices[i + 1]], corners[indices[i + 2]]);
                    Assert.True(clockwise ? area > 0 : area < 0, $"seed {seed}: triangle {i / 3} has the area {area}");
                    sum += area;
                }

                Assert.Equal(clockwise, new Vertices(corners).GetSignedArea() > 0);
                float whole = new Vertices(outline).GetArea();
                Assert.Equal(whole, Math.Abs(sum), 1e-5 * whole);
                Assert.All(corners, corner => Assert.Contains(corner, outline));
            }
        }

        [Fact]
        public void Outlines_ThatAreNone_AreRefused()
        {
            Vector2[] bow = { new Vector2(0, 0), new Vector2(1, 1), new Vector2(1, 0), new Vector2(0, 1) };
            foreach (Vector2[] wrong in new[] { bow, bow.Take(2).ToArray(), new[] { bow[0], bow[1], 2 * bow[1] } })
            {
                Assert.Equal("inputVertices", Assert.ThrowsAny<ArgumentException>(
                    () => Vertices.Triangulate(wrong, Vertices.WindingOrder.Clockwise, out _, out _)).ParamName);
            }

            Assert.Throws<ArgumentNullException>(() => Vertices.Triangulate(null, Vertices.WindingOrder.Clockwise, out _, out _));
        }

        private static double Area(Vector2 a, Vector2 b, Vector2 c) =>
            0.5 * ((((double)b.X - a.X) * ((double)c.Y - a.Y)) - (((double)b.Y - a.Y) * ((double)c.X - a.X)));

        /// <summary>Three to thirty corners, in either order, dented or not.</summary>
        private static Vector2[] Star(Random random)
        {
            int count = random.Next(3, 31);
            float size = MathF.Pow(10, (4 * (float)random.NextDouble()) - 2);
            var outline = new Vector2[count];
            for (int i = 0; i < count; i++)
            {
                double angle = 2 * Math.PI * i / count;
                double reach = size * (0.2 + random.NextDouble());
                outline[i] = new Vector2((float)(reach * Math.Cos(angle)), (float)(reach * Math.Sin(angle)));
            }

            if (random.Next(2) == 0)
            {
                Array.Reverse(outline);
            }

            return outline;
        }
    }
}
