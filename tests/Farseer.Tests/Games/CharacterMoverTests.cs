using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Games;

/// <summary>What a character does, each by itself. In metres, y up; it is 1.8 high and 0.8 wide.</summary>
public sealed class CharacterMoverTests
{
    private const float Step = 1f / 60;
    private const float Height = 1.8f;
    private readonly PhysicsSimulator _simulator = new PhysicsSimulator(new Vector2(0, -10));

    [Fact]
    public void Character_FallsLandsAndWalks()
    {
        Block(0, -1, 100, 2);
        CharacterMover character = Character(0, 3);
        Walk(character, 0, 90);
        Assert.True(character.IsGrounded);
        Assert.Equal(0, Feet(character), 0.02);
        Walk(character, 4, 60);
        Assert.Equal(4, character.Body.PositionX, 0.01);
        Assert.Equal(0, Feet(character), 0.02);
        Assert.Equal(Vector2.Zero, character.GroundVelocity);
    }

    [Fact]
    public void Character_StopsAtAWall_AndSlidesAlongItInTheAir()
    {
        Block(0, -1, 100, 2);
        Block(3, 5, 1, 12);
        CharacterMover character = Character(0, Height / 2);
        Walk(character, 4, 120);
        Assert.Equal(2.5 - 0.4, character.Body.PositionX, 0.02);
        Assert.True(character.TouchesWall);
        Assert.Equal(0, character.Velocity.X, 1e-4f);
        character.Velocity = new Vector2(4, 6);
        float highest = 0;
        for (int i = 0; i < 60; i++)
        {
            character.Velocity = new Vector2(4, character.Velocity.Y);
            Update(character);
            highest = Math.Max(highest, (float)Feet(character));
        }

        // v² / 2g.
        Assert.Equal(1.8f, highest, 0.05f);
    }

    [Fact]
    public void Character_WalksUpASlope_AtItsLevelSpeed_AndStandsOnItStill()
    {
        Slope(40);
        CharacterMover character = Character(-2, Height / 2);
        Walk(character, 2, 120);
        double x = character.Body.PositionX;
        Assert.Equal(2, x, 0.1);
        Assert.True(character.IsGrounded);
        Assert.InRange(Feet(character), 1.3, 2.1);
        Walk(character, 0, 120);
        Assert.Equal(x, character.Body.PositionX, 1e-3);
        Assert.True(character.IsGrounded);
    }

    [Fact]
    public void Character_DoesNotWalkUpWhatIsTooSteep()
    {
        Slope(60);
        CharacterMover character = Character(-2, Height / 2);
        Walk(character, 2, 240);
        Assert.InRange(character.Body.PositionX, -1, 0.2);
        Assert.InRange(Feet(character), -0.02, 0.3);
    }

    [Fact]
    public void Character_WalksUpSteps_AndNotUpWhatIsTooHigh()
    {
        Block(0, -1, 100, 2);
        for (int i = 0; i < 5; i++)
        {
            Block(3.5f + (0.5f * i), 0.1f * (i + 1), 5, 0.2f * (i + 1));
        }

        Block(12, 1.5f, 1, 3);
        CharacterMover character = Character(-1, Height / 2);
        character.StepHeight = 0.25f;
        Walk(character, 3, 120);
        Assert.Equal(1, Feet(character), 0.03);
        Assert.True(character.IsGrounded);
        Block(-8, 0.15f, 2, 0.3f);
        CharacterMover low = Character(-3, Height / 2);
        low.StepHeight = 0.25f;
        Walk(low, -3, 120);
        Assert.Equal(0, Feet(low), 0.02);
        Assert.InRange(low.Body.PositionX, -6.7, -6.5);
        low.StepHeight = 0.35f;
        Walk(low, -3, 20);
        Assert.Equal(0.3, Feet(low), 0.02);
    }

    [Fact]
    public void Character_KeepsToTheGroundDownhill_AndLeavesItWithoutSnapping()
    {
        Slope(-30);
        CharacterMover character = Character(-2, Height / 2);
        int airborne = 0;
        for (int i = 0; i < 60; i++)
        {
            Walk(character, 5, 1);
            airborne += i > 0 && !character.IsGrounded ? 1 : 0;
        }

        Assert.Equal(0, airborne);
        CharacterMover leaps = Character(-2, Height / 2);
        leaps.SnapDistance = 0;
        bool left = false;
        for (int i = 0; i < 60; i++)
        {
            Walk(leaps, 5, 1);
            left |= !leaps.IsGrounded;
        }

        Assert.True(left);
    }

    [Fact]
    public void Character_ThatJumps_IsNotSnappedBack_AndReachesItsHeight()
    {
        Block(0, -1, 100, 2);
        CharacterMover character = Character(0, Height / 2);
        Walk(character, 0, 5);
        character.Velocity = new Vector2(0, 6);
        double highest = 0;
        for (int i = 0; i < 90; i++)
        {
            Update(character);
            highest = Math.Max(highest, Feet(character));
        }

        Assert.Equal(1.8, highest, 0.03);
        Assert.True(character.IsGrounded);
    }

    [Fact]
    public void Character_RidesOnAMovingPlatform_AndTakesItsVelocityAlong()
    {
        Body lift = Block(0, -0.5f, 6, 1);
        lift.IsStatic = false;
        lift.IsKinematic = true;
        CharacterMover character = Character(0, Height / 2);
        Walk(character, 0, 5);
        for (int i = 0; i < 120; i++)
        {
            lift.LinearVelocity = new Vector2(1, i < 60 ? 0.5f : -0.5f);
            Walk(character, 0, 1);
            Assert.True(character.IsGrounded);
        }

        Assert.Equal(lift.PositionX, character.Body.PositionX, 0.02);
        Assert.Equal(lift.PositionY + 0.5, Feet(character), 0.03);
        Assert.Equal(1, character.GroundVelocity.X, 1e-4f);
        character.Velocity = new Vector2(0, 4);
        Update(character);
        Assert.Equal(1, character.Velocity.X, 1e-3f);
    }

    [Fact]
    public void Character_GoesRoundOnATurningPlatform()
    {
        Body wheel = Block(0, -0.5f, 12, 1);
        wheel.IsStatic = false;
        wheel.IsKinematic = true;
        wheel.AngularVelocity = 0.2f;
        CharacterMover character = Character(4, Height / 2);
        Walk(character, 0, 60);
        Assert.True(character.IsGrounded);

        // Up with the platform under it, and hardly to the side.
        Assert.InRange(Feet(character), 0.6, 0.95);
        Assert.InRange(character.Body.PositionX, 3.6, 4.1);
    }

    [Fact]
    public void Character_IsNotDraggedByAWallThatSlidesBeside_AndIsPushedByOneThatComes()
    {
        Block(0, -1, 100, 2);
        Body wall = Block(1, 2, 1, 4);
        wall.IsStatic = false;
        wall.IsKinematic = true;
        CharacterMover character = Character(0, Height / 2);
        Walk(character, 2, 30);
        wall.LinearVelocity = new Vector2(0, 2);
        Walk(character, 2, 30);
        Assert.Equal(0, Feet(character), 0.02);
        Assert.Equal(0.1, character.Body.PositionX, 0.03);
        wall.LinearVelocity = new Vector2(-1, 0);
        Walk(character, 0, 60);
        Assert.Equal(-0.9, character.Body.PositionX, 0.05);
        wall.LinearVelocity = new Vector2(1, 0);
        Walk(character, 0, 60);
        Assert.Equal(-0.9, character.Body.PositionX, 0.05);
    }

    [Fact]
    public void Character_PassesAOneWayPlatformFromBelow_StandsOnIt_AndDropsThrough()
    {
        Block(0, -1, 100, 2);
        Body platform = Block(0, 2.5f, 4, 0.2f);
        platform.Geoms[0].OneWayDirection = new Vector2(0, 1);
        CharacterMover character = Character(0, Height / 2);
        Walk(character, 0, 5);
        character.Velocity = new Vector2(0, 8);
        for (int i = 0; i < 120; i++)
        {
            Update(character);
        }

        Assert.Equal(2.6, Feet(character), 0.03);
        Assert.Same(platform.Geoms[0], character.Ground);
        character.DropsThrough = true;
        Walk(character, 0, 10);
        character.DropsThrough = false;
        Walk(character, 0, 80);
        Assert.Equal(0, Feet(character), 0.03);
    }

    [Theory]
    [InlineData(0, 1, false)]
    [InlineData(50, 1, true)]
    [InlineData(50, 100, false)]
    public void Character_PushesAsHardAsItMay(float force, float mass, bool moves)
    {
        Block(0, -1, 100, 2);
        Body crate = BodyFactory.Instance.CreateRectangleBody(_simulator, 1, 1, mass);
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(_simulator, crate, 1, 1);
        geom.FrictionCoefficient = 0.5f;
        crate.Position = new Vector2(2, 0.5f);
        _simulator.GeomList.ForEach(g => g.FrictionCoefficient = 0.5f);
        CharacterMover character = Character(0, Height / 2);
        character.PushForce = force;
        Walk(character, 2, 180);
        if (moves)
        {
            Assert.InRange(crate.PositionX, 4, 8);
            Assert.InRange(crate.LinearVelocity.X, 0, 2.1f);
        }
        else
        {
            Assert.Equal(2, crate.PositionX, 0.02);
            Assert.Equal(1.1, character.Body.PositionX, 0.03);
        }
    }

    [Fact]
    public void Character_PressesOnWhatItStandsOn_WithItsWeight()
    {
        Body plank = BodyFactory.Instance.CreateRectangleBody(_simulator, 6, 0.2f, 5);
        GeomFactory.Instance.CreateRectangleGeom(_simulator, plank, 6, 0.2f);
        JointFactory.Instance.CreateFixedRevoluteJoint(_simulator, plank, Vector2.Zero);
        CharacterMover character = Character(1.5f, 1.02f);
        character.Mass = 60;
        Walk(character, 0, 30);
        Assert.True(plank.TotalRotation < -0.1f);
    }

    [Fact]
    public void Character_StopsAtACeiling()
    {
        Block(0, -1, 100, 2);
        Block(0, 3, 100, 2);
        CharacterMover character = Character(0, Height / 2);
        Walk(character, 0, 5);
        character.Velocity = new Vector2(0, 8);
        for (int i = 0; i < 10; i++)
        {
            Update(character);
            Assert.True(Feet(character) <= 0.2);
        }

        Assert.True(character.Velocity.Y <= 0);
    }

    [Fact]
    public void Character_StandsAlongItsUp()
    {
        _simulator.Gravity = new Vector2(10, 0);
        Block(1, 0, 2, 100);
        CharacterMover character = Character(-3, 0);
        character.Up = new Vector2(-1, 0);
        for (int i = 0; i < 90; i++)
        {
            character.Velocity = new Vector2(character.Velocity.X, 1);
            Update(character);
        }

        Assert.True(character.IsGrounded);
        Assert.Equal(-0.9, character.Body.PositionX, 0.02);
        Assert.InRange(character.Body.PositionY, 1.2, 1.6);
    }

    [Fact]
    public void Character_IsFilteredAndRemoved()
    {
        Block(0, -1, 100, 2);
        Body wall = Block(2, 2, 1, 4);
        wall.Geoms[0].CollisionCategories = CollisionCategory.Cat5;
        CharacterMover character = Character(0, Height / 2);
        character.Filter.Categories = CollisionCategory.All & ~CollisionCategory.Cat5;
        Walk(character, 3, 90);
        Assert.True(character.Body.PositionX > 4);
        character.Remove();
        _simulator.Update(Step);
        Assert.DoesNotContain(character.Body, _simulator.BodyList);
        Assert.Throws<ArgumentOutOfRangeException>("height", () => new CharacterMover(_simulator, Vector2.Zero, 1, 0.5f));
        Assert.Throws<ArgumentOutOfRangeException>(() => character.MaxSlope = 2);
    }

    private static double Feet(CharacterMover character) => character.Body.PositionY - (Height / 2);

    private CharacterMover Character(float x, float y) => new CharacterMover(_simulator, new Vector2(x, y), Height, 0.4f);

    private void Walk(CharacterMover character, float speed, int steps)
    {
        for (int i = 0; i < steps; i++)
        {
            character.Velocity = new Vector2(speed, character.Velocity.Y);
            Update(character);
        }
    }

    private void Update(CharacterMover character)
    {
        character.Move(Step);
        _simulator.Update(Step);
    }

    private Body Block(float x, float y, float width, float height)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(_simulator, width, height, 1);
        body.IsStatic = true;
        body.Position = new Vector2(x, y);
        GeomFactory.Instance.CreateRectangleGeom(_simulator, body, width, height);
        return body;
    }

    /// <summary>Level ground to the left of 0, and a slope to the right.</summary>
    private void Slope(float degrees)
    {
        float rise = 20 * MathF.Tan(degrees * MathF.PI / 180);
        var body = new Body { IsStatic = true };
        var points = new Vertices { new Vector2(20, rise), new Vector2(0, 0), new Vector2(-20, 0) };
        GeomFactory.Instance.CreateChainGeom(_simulator, body, points, false);
    }
}
