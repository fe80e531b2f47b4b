using FarseerGames.FarseerPhysics.Mathematics;
using Xunit;

namespace Farseer.Porting.Tests
{
    /// <summary>The old forms of the vector and the matrix compile and mean what they did.</summary>
    public sealed class AliasTests
    {
        private Vector2 _a = new Vector2(3, 4);
        private Vector2 _b = new Vector2(1, -2);

        [Fact]
        public void Vector2_RefForms_EqualTheOperators()
        {
            Vector2 c;
            Vector2.Add(ref _a, ref _b, out c);
            Assert.Equal(_a + _b, c);
            Vector2.Subtract(ref _a, ref _b, out c);
            Assert.Equal(_a - _b, c);
            Vector2.Multiply(ref _a, ref _b, out c);
            Assert.Equal(_a * _b, c);
            Vector2.Multiply(ref _a, 2, out c);
            Assert.Equal(_a * 2, c);
            Vector2.Divide(ref _a, ref _b, out c);
            Assert.Equal(_a / _b, c);
            Vector2.Divide(ref _a, 2, out c);
            Assert.Equal(_a / 2, c);
            Vector2.Negate(ref _a, out c);
            Assert.Equal(-_a, c);
            Vector2.Max(ref _a, ref _b, out c);
            Assert.Equal(new Vector2(3, 4), c);
            Vector2.Min(ref _a, ref _b, out c);
            Assert.Equal(new Vector2(1, -2), c);
        }

        [Fact]
        public void Vector2_Measures_AreTheSameByReference()
        {
            float value;
            Vector2.Dot(ref _a, ref _b, out value);
            Assert.Equal(-5, value);
            Vector2.DistanceSquared(ref _a, ref _b, out value);
            Assert.Equal(40, value);
            Vector2.Distance(ref _a, ref _b, out value);
            Assert.Equal(Vector2.Distance(_a, _b), value);
        }

        [Fact]
        public void Vector2_ResultInAnInput_IsRight()
        {
            Vector2.Add(ref _a, ref _b, out _a);
            Assert.Equal(new Vector2(4, 2), _a);
        }

        [Fact]
        public void Vector2_Normalize_WorksInPlaceByReferenceAndByValue()
        {
            Vector2 unit = new Vector2(0.6f, 0.8f);
            Vector2 byReference;
            Vector2.Normalize(ref _a, out byReference);
            Assert.Equal(unit, byReference);
            Assert.Equal(unit, Vector2.Normalize(_a));
            _a.Normalize();
            Assert.Equal(unit, _a);
        }

        [Fact]
        public void Vector2_Splines_PassThroughTheirPoints()
        {
            Vector2 far = new Vector2(9, 9);
            Vector2 c;
            Vector2.Lerp(ref _a, ref _b, 0.5f, out c);
            Assert.Equal(new Vector2(2, 1), c);
            Vector2.SmoothStep(ref _a, ref _b, 0.5f, out c);
            Assert.Equal(new Vector2(2, 1), c);
            Assert.Equal(_b, Vector2.SmoothStep(_a, _b, 7));
            Vector2.CatmullRom(ref far, ref _a, ref _b, ref far, 1, out c);
            Assert.Equal(_b, c);
            Vector2.Hermite(ref _a, ref far, ref _b, ref far, 0, out c);
            Assert.Equal(_a, c);
            Vector2.Barycentric(ref _a, ref _b, ref far, 1, 0, out c);
            Assert.Equal(_b, c);
        }

        [Fact]
        public void Matrix_TurnsAndMoves_LikeTheOldOne()
        {
            Matrix turn, move, both, back;
            Matrix.CreateRotationZ(MathHelper.PiOver2, out turn);
            Matrix.CreateTranslation(10, 20, 0, out move);
            Matrix.Multiply(ref turn, ref move, out both);
            Vector2 c;
            Vector2.Transform(ref _a, ref both, out c);

            // (3, 4) turned by a right angle is (-4, 3); the float of pi/2 is off by 4.4e-8, times 4.
            Assert.Equal(6, c.X, 5);
            Assert.Equal(23, c.Y, 5);
            Matrix.Invert(ref both, out back);
            Vector2.Transform(ref c, ref back, out c);
            Assert.Equal(3, c.X, 4);
            Assert.Equal(4, c.Y, 4);
            Assert.Equal(back, Matrix.Invert(both));
            Vector2.TransformNormal(ref _a, ref both, out c);
            Assert.Equal(-4, c.X, 5);
            Assert.Equal(turn.M12, both.Right.Y);
            Assert.Equal(both.M21, Matrix.Multiply(turn, move).Up.X);
            Assert.Equal(new Vector3(0, -1, 0), Matrix.Identity.Down);
            Assert.Equal(new Vector3(0, 1, 0), Vector3.Up);
        }

        [Fact]
        public void MathHelper_OfXna_IsThere()
        {
            Assert.Equal(MathHelper.Pi, MathHelper.ToRadians(MathHelper.ToDegrees(MathHelper.Pi)), 6);
            Assert.Equal(MathHelper.Pi - 1, MathHelper.WrapAngle(-MathHelper.Pi - 1), 5);
            Assert.Equal(0.5f, MathHelper.SmoothStep(0, 1, 0.5f));
            Assert.Equal(2, MathHelper.CatmullRom(1, 2, 3, 4, 0));
            Assert.Equal(1, MathHelper.Hermite(0, 0, 1, 0, 1));
            Assert.Equal(3, MathHelper.Barycentric(1, 3, 5, 1, 0));
            Vector4 four = new Vector4(1, 2, 3, 4);
            Assert.Equal(4, four.W);
            Matrix moved = Matrix.CreateTranslation(new Vector3(1, 2, 3));
            Assert.Equal(-1, moved.Left.X);
        }
    }
}
