using System;
using Farseer.Porting.Tests.Programs;
using Xunit;

namespace Farseer.Porting.Tests
{
    /// <summary>The programs do what their games call for. Steps are 1/60 s.</summary>
    public sealed class ProgramTests
    {
        private const float Dt = 1f / 60;
        private static readonly float[] _breaks = new float[] { 480, 490, 495, 500, 505, 510, 520 };

        [Fact]
        public void PlatformerHero_RunsAndJumps_CollectsCoinsAndLandsOnTheStep()
        {
            var game = new PlatformerHero();
            for (int i = 0; i < 60; i++)
            {
                game.Update(Dt, false, false);
            }

            Assert.True(game.IsOnGround);

            // The floor's top is at 190 and the hero is 32 high: it stands at 174, and two rest depths lower at most.
            Assert.InRange(game.Position.Y, 174, 174.1f);

            for (int i = 0; i < 400; i++)
            {
                game.Update(Dt, game.Position.X < 290, game.Position.X > 150 && game.Position.X < 200);
            }

            Assert.Equal(3, game.Coins);
            Assert.InRange(game.Jumps, 1, 3);
            Assert.True(game.IsOnGround);
            Assert.InRange(game.Position.Y, 134, 134.1f);
            // The largest float as inertia: only rounding-sized turns.
            Assert.InRange(game.Rotation, -1e-30f, 1e-30f);
        }

        [Fact]
        public void PooledBullets_FiredForTenSeconds_AreUsedAgain()
        {
            var game = new PooledBullets();
            for (int i = 0; i < 600; i++)
            {
                if (i % 6 == 0)
                {
                    game.Fire(i % 12 == 0 ? 0 : 3);
                }

                game.Update(Dt);
            }

            Assert.Equal(100, game.Fired);
            Assert.InRange(game.Hits, 40, 50);
            Assert.InRange(game.Made, 10, 30);
            Assert.True(game.TargetSpeed > 5, $"The target moves at {game.TargetSpeed}.");
        }

        [Theory]
        [InlineData(400f, true)]
        [InlineData(60f, false)]
        public void BreakableWall_HitByBall_BreaksOnlyWhenHitHard(float speed, bool breaks)
        {
            var game = new BreakableWall(speed);
            for (int i = 0; i < 300; i++)
            {
                game.Update(Dt);
            }

            Assert.Equal(10, game.Bricks + game.Debris.Count);
            Assert.Equal(breaks, game.Debris.Count > 0);

            // What broke off lies on the floor (top at 100), not in it.
            Assert.All(game.Debris, piece => Assert.True(piece.Position.Y < 95));
        }

        [Fact]
        public void PhysicsThread_RunsFrames_GivesTheSameAsInOneThread()
        {
            using var threaded = new PhysicsThread();
            for (int i = 0; i < 120; i++)
            {
                threaded.Frame(Dt);
            }

            Assert.Equal(120, threaded.Frames);

            // The box rests on the floor (top at 50) by half its height.
            Assert.InRange(threaded.Box.Position.Y, 45, 45.06f);
        }

        [Fact]
        public void Billiards_Broken_AllBallsStayOnTheTableAndSlowDown()
        {
            int whole = 0;
            foreach (float power in _breaks)
            {
                var game = new Billiards();
                game.Shoot(power);
                float first = 0;
                int moved = 0;
                for (int i = 0; i < 600; i++)
                {
                    game.Update(Dt);
                    first = i == 0 ? game.Energy() : first;
                    moved = Math.Max(moved, game.Moved);
                    Assert.True(game.AllOnTable());
                }

                // In steps 2 to 64 times as fine all are struck by 41 of 42 such breaks, in these by five of seven: the last one is missed.
                Assert.InRange(moved, 15, 16);
                whole += moved / 16;
                Assert.True(game.Energy() < 0.2f * first, $"{game.Energy()} of {first} after {power}");
            }

            Assert.InRange(whole, 4, _breaks.Length);
        }

        [Fact]
        public void Asteroids_TurnAndThrust_MovesWhereTheNosePoints()
        {
            var game = new Asteroids();
            for (int i = 0; i < 20; i++)
            {
                game.Update(Dt, 1, false);
            }

            for (int i = 0; i < 20; i++)
            {
                game.Update(Dt, -1, false);
            }

            Vector2 nose = game.Nose() - game.Ship.Position;
            // The default drag leaves a little spin: it turns the nose by less than a degree in a second.
            for (int i = 0; i < 60; i++)
            {
                game.Update(Dt, 0, true);
            }

            Vector2 velocity = game.Ship.LinearVelocity;
            velocity.Normalize();
            nose.Normalize();
            float cosine;
            Vector2.Dot(ref velocity, ref nose, out cosine);
            Assert.True(game.Ship.Rotation != 0);
            Assert.True(cosine > 0.99f, $"cosine {cosine}");
        }

        [Fact]
        public void MousePicking_DragAndLetGo_BoxFollowsTheMouse()
        {
            var game = new MousePicking();
            Assert.Null(game.MouseDown(new Vector2(0, 0)));
            Assert.Same(game.BoxGeom, game.MouseDown(new Vector2(110, 104)));
            for (int i = 0; i < 900; i++)
            {
                game.MouseMove(new Vector2(110 + System.Math.Min(i, 120), 104));
                game.Update(Dt);
            }

            // At rest the spring of 20 holds a weight of 50.
            Assert.True(game.IsHolding);
            Assert.InRange(game.Stretch(), 2.4f, 2.6f);
            game.MouseUp();
            Assert.False(game.IsHolding);
            float height = game.Box.Position.Y;
            for (int i = 0; i < 60; i++)
            {
                game.Update(Dt);
            }

            Assert.True(game.Box.Position.Y > height + 10);
        }

        [Fact]
        public void Tank_DrivenAndAimed_RollsOnAndRaisesItsBarrel()
        {
            var game = new Tank();
            for (int i = 0; i < 300; i++)
            {
                game.Update(Dt, 1500, -30);
                Assert.True(game.HingeError < 0.5f, $"hinge {game.HingeError}");
            }

            Assert.True(game.Hull.Position.X > 50, $"x {game.Hull.Position.X}");
            Assert.InRange(game.BarrelAngle, -0.56f, -0.48f);
            Assert.InRange(game.Hull.Position.Y, 45, 57);
        }

        [Fact]
        public void Water_LightAndHeavyBox_OneFloatsAndOneSinks()
        {
            var game = new Water();
            for (int i = 0; i < 900; i++)
            {
                game.Update(Dt);
            }

            Assert.Equal(2, game.Entered.Count);
            // It fell from 40 above and still bobs: little of a float this light is in the water, and little drags at it.
            Assert.InRange(game.Float.Position.Y, game.Surface - 40, game.Surface + 40);
            Assert.True(game.Stone.Position.Y > game.Surface + 50);
        }

        [Fact]
        public void Pinball_Flip_ThrowsTheBallAtTheBumper()
        {
            var game = new Pinball();
            for (int i = 0; i < 60; i++)
            {
                game.Update(Dt, false);
            }

            Assert.InRange(game.Angle, 0.38f, 0.42f);
            for (int i = 0; i < 60; i++)
            {
                game.Update(Dt, i < 20);
                Assert.True(game.AxleError < 0.5f, $"axle {game.AxleError}");
                Assert.InRange(game.Angle, -0.65f, 0.45f);
            }
        }

        [Fact]
        public void RopeBridge_WithCrates_StaysTautAndHolds()
        {
            var game = new RopeBridge();
            for (int i = 0; i < 600; i++)
            {
                game.Update(Dt);
            }

            Assert.True(game.LargestError() < 0.05f, $"error {game.LargestError()}");
            // The planks are as long as the gap: nothing can sag.
            Assert.InRange(game.Sag(), -0.5f, 0.5f);
            Assert.True(game.CratesAreUp());
        }

        [Fact]
        public void FrameTime_SlowFramesAndRest_LengthensTheStepAndWakesWhatIsNear()
        {
            var game = new FrameTime();
            for (int i = 0; i < 60; i++)
            {
                game.Frame(Dt, Dt);
            }

            Assert.Equal(0, game.Awake);
            game.Visit(10);
            int most = 0;
            for (int i = 0; i < 30; i++)
            {
                game.Frame(Dt, Dt);
                most = Math.Max(most, game.Awake);
            }

            Assert.InRange(most, 1, 3);
        }
    }
}
