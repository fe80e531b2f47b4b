using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Samples.Terminal;

/// <summary>Draws the geoms of a scene into a canvas so that gravity points down and a metre is as long either way.</summary>
internal sealed class ScenePainter
{
    private readonly BrailleCanvas _canvas;
    private readonly HashSet<Body> _touching = [];
    private double _scale;
    private double _left;
    private double _top;
    private int _up;
    private double _restSpeed;

    public ScenePainter(BrailleCanvas canvas) => _canvas = canvas;

    /// <summary>A body to show in a colour of its own.</summary>
    public Body? Chosen { get; set; }

    /// <summary>What points up on the screen, in the world.</summary>
    public Vector2 Up => new(0f, -_up);

    /// <summary>The place in the world of a dot of the last picture.</summary>
    public Vector2 ToWorld(double x, double y) => new((float)((x - _left) / _scale), (float)((y - _top) / (_up * _scale)));

    /// <summary>The length in the world of so many dots.</summary>
    public float ToWorld(double dots) => (float)(dots / _scale);

    public void Paint(Scene scene, PhysicsSimulator simulator, bool contacts)
    {
        // Gravity along +y means a world drawn with y down, as on a screen; anything else is drawn as on paper.
        _up = simulator.Gravity.Y > 0f ? 1 : -1;
        Fit(scene.View);
        Paint(simulator, 0.0, 1f, Vector2.Zero, contacts);
        foreach (SceneCompanion companion in scene.Companions)
        {
            Paint(companion.Simulator, companion.ShiftX, companion.Scale, companion.Offset, contacts);
        }
    }

    private void Fit(SceneView view)
    {
        double width = Math.Max(view.Max.X - view.Min.X, 1e-30);
        double height = Math.Max(view.Max.Y - view.Min.Y, 1e-30);
        _scale = Math.Min((_canvas.Width - 1) / width, (_canvas.Height - 1) / height);
        _left = ((_canvas.Width - 1) * 0.5) - (_scale * 0.5 * (view.Min.X + (double)view.Max.X));
        _top = ((_canvas.Height - 1) * 0.5) - (_up * _scale * 0.5 * (view.Min.Y + (double)view.Max.Y));

        // Slower than the picture's height in ten minutes looks still.
        _restSpeed = height / 600.0;
    }

    private void Paint(PhysicsSimulator simulator, double shiftX, float scale, Vector2 offset, bool contacts)
    {
        _touching.Clear();
        foreach (Arbiter arbiter in simulator.ArbiterList)
        {
            _touching.Add(arbiter.GeomA!.Body);
            _touching.Add(arbiter.GeomB!.Body);
        }

        foreach (Geom geom in simulator.GeomList)
        {
            Paint(geom, shiftX, scale, offset);
        }

        if (!contacts)
        {
            return;
        }

        foreach (Arbiter arbiter in simulator.ArbiterList)
        {
            foreach (Contact contact in arbiter.ContactList!)
            {
                double x = ((contact.Position.X + shiftX) * scale) + offset.X;
                double y = (contact.Position.Y * (double)scale) + offset.Y;
                _canvas.Dot((int)(_left + (_scale * x)), (int)(_top + (_up * _scale * y)), Palette.Contact, 255);
            }
        }
    }

    private void Paint(Geom geom, double shiftX, float scale, Vector2 offset)
    {
        // Turned here from the local outline: the world outline is single precision, too coarse far from the origin.
        Body body = geom.Body;
        double centreX = ((body.PositionX + (geom.Position.X - (double)body.Position.X) + shiftX) * scale) + offset.X;
        double centreY = ((body.PositionY + (geom.Position.Y - (double)body.Position.Y)) * scale) + offset.Y;
        double cos = Math.Cos(geom.Rotation) * scale;
        double sin = Math.Sin(geom.Rotation) * scale;
        (byte color, byte rank) = State(geom, scale);
        Vertices outline = geom.LocalVertices;
        double lastX = 0.0;
        double lastY = 0.0;
        for (int i = 0; i <= outline.Count; i++)
        {
            Vector2 local = outline[i == outline.Count ? 0 : i];
            double x = _left + (_scale * (centreX + (cos * local.X) - (sin * local.Y)));
            double y = _top + (_up * _scale * (centreY + (sin * local.X) + (cos * local.Y)));
            if (i > 0)
            {
                _canvas.Line(lastX, lastY, x, y, color, rank);
            }

            lastX = x;
            lastY = y;
        }
    }

    private (byte Color, byte Rank) State(Geom geom, float scale)
    {
        Body body = geom.Body;
        if (body == Chosen)
        {
            return (Palette.Chosen, 6);
        }

        if (geom.IsSensor)
        {
            return (Palette.Sensor, 1);
        }

        if (!body.Enabled)
        {
            return (Palette.Disabled, 0);
        }

        if (body.IsKinematic)
        {
            return (Palette.Driven, 2);
        }

        if (body.IsStatic)
        {
            return (Palette.Static, 0);
        }

        if (!_touching.Contains(body))
        {
            return (Palette.Flying, 5);
        }

        AABB box = geom.AABB;
        double reach = 0.5 * Math.Max(box.Width, box.Height);
        double speed = (body.LinearVelocity.Length() + (Math.Abs(body.AngularVelocity) * reach)) * scale;
        return speed < _restSpeed ? (Palette.Resting, (byte)3) : (Palette.Touching, (byte)4);
    }
}
