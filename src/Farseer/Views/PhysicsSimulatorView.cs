using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Views;

/// <summary>
/// Draws what is in a simulator, for debugging: geoms in the colours of their states, vertices, grids, boxes, contacts with normals
/// and impulses, joints and springs with their anchors and errors, fluids. Each part can be switched off.
/// </summary>
/// <example>
/// <code>
/// var view = new PhysicsSimulatorView(simulator, draw) { EnableAABBView = true };
/// view.Draw();
/// </code>
/// </example>
public partial class PhysicsSimulatorView
{
    private readonly PhysicsSimulator _simulator;
    private readonly IDebugDraw _draw;
    private readonly HashSet<Body> _touching = new HashSet<Body>();
    private readonly Vertices _corners = new Vertices();
    private readonly List<Body> _bodies = new List<Body>();
    private readonly List<Joint> _joints = new List<Joint>();
    private readonly List<Spring> _springs = new List<Spring>();

    /// <summary>Makes a view.</summary>
    /// <param name="physicsSimulator">The simulator to draw.</param>
    /// <param name="debugDraw">The drawing to use.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public PhysicsSimulatorView(PhysicsSimulator physicsSimulator, IDebugDraw debugDraw)
    {
        _simulator = Require.NotNull(physicsSimulator, nameof(physicsSimulator));
        _draw = Require.NotNull(debugDraw, nameof(debugDraw));
    }

    /// <summary>Draws the outlines of geoms. Default true.</summary>
    public bool EnableEdgeView { get; set; } = true;

    /// <summary>Draws the vertices of geoms. Default false.</summary>
    public bool EnableVerticeView { get; set; }

    /// <summary>Draws the boxes around geoms. Default false.</summary>
    public bool EnableAABBView { get; set; }

    /// <summary>Draws the points of the distance grids, which are made for it if need be. Default false.</summary>
    public bool EnableGridView { get; set; }

    /// <summary>Draws contacts with their normals, as long as their impulses say. Default true.</summary>
    public bool EnableContactView { get; set; } = true;

    /// <summary>Draws the position and the axes of each body. Default false.</summary>
    public bool EnableCoordinateAxisView { get; set; }

    /// <summary>Draws springs from anchor to anchor, redder the larger their error. Default true.</summary>
    public bool EnableSpringView { get; set; } = true;

    /// <summary>Draws joints from body to body over their anchors, redder the larger their error. Default true.</summary>
    public bool EnableJointView { get; set; } = true;

    /// <summary>Draws the fluids of wave controllers, and of fluid controllers whose container is a box. Default true.</summary>
    public bool EnableFluidView { get; set; } = true;

    /// <summary>
    /// Length, in the world, of a body's axes and of the normal of the strongest contact; finite and at least 0. Default 10.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MarkLength
    {
        get => _markLength;
        set => _markLength = Require.NotNegative(value, nameof(MarkLength));
    }

    /// <summary>Diameter, in pixels, of marked points; finite and at least 0. Default 4.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float PointSize
    {
        get => _pointSize;
        set => _pointSize = Require.NotNegative(value, nameof(PointSize));
    }

    /// <summary>Colour of geoms of bodies that move without touching anything. Default (38, 115, 191).</summary>
    public DebugColor FreeColor { get; set; } = new DebugColor(38, 115, 191);

    /// <summary>Colour of geoms in contact. Default (30, 140, 80).</summary>
    public DebugColor TouchingColor { get; set; } = new DebugColor(30, 140, 80);

    /// <summary>Colour of geoms of static bodies. Default (110, 110, 110).</summary>
    public DebugColor StaticColor { get; set; } = new DebugColor(110, 110, 110);

    /// <summary>Colour of geoms of kinematic bodies. Default (150, 90, 190).</summary>
    public DebugColor KinematicColor { get; set; } = new DebugColor(150, 90, 190);

    /// <summary>
    /// Colour of geoms of bodies that are disabled, or put to sleep by an inactivity controller. Default (180, 180, 200).
    /// </summary>
    public DebugColor SleepingColor { get; set; } = new DebugColor(180, 180, 200);

    /// <summary>Colour of sensors. Default (200, 160, 20).</summary>
    public DebugColor SensorColor { get; set; } = new DebugColor(200, 160, 20);

    /// <summary>Colour of vertices. Default (20, 20, 20).</summary>
    public DebugColor VerticeColor { get; set; } = new DebugColor(20, 20, 20);

    /// <summary>Colour of boxes. Default (170, 170, 90).</summary>
    public DebugColor AABBColor { get; set; } = new DebugColor(170, 170, 90);

    /// <summary>Colour of grid points inside a geom; those outside are half as opaque. Default (90, 160, 160).</summary>
    public DebugColor GridColor { get; set; } = new DebugColor(90, 160, 160);

    /// <summary>Colour of contacts and their normals. Default (200, 40, 40).</summary>
    public DebugColor ContactColor { get; set; } = new DebugColor(200, 40, 40);

    /// <summary>Colour of springs at rest. Default (90, 170, 60).</summary>
    public DebugColor SpringColor { get; set; } = new DebugColor(90, 170, 60);

    /// <summary>Colour of joints. Default (120, 80, 30).</summary>
    public DebugColor JointColor { get; set; } = new DebugColor(120, 80, 30);

    /// <summary>
    /// Colour of springs with a large error, as long as their rest length or near their breakpoint, and of joints near theirs. Default
    /// (220, 60, 40).
    /// </summary>
    public DebugColor StrainedColor { get; set; } = new DebugColor(220, 60, 40);

    /// <summary>Colour of fluids. Default (60, 170, 210).</summary>
    public DebugColor FluidColor { get; set; } = new DebugColor(60, 170, 210);

    /// <summary>Colour of the axes of bodies; the y axis is half as opaque. Default (60, 60, 60).</summary>
    public DebugColor AxisColor { get; set; } = new DebugColor(60, 60, 60);

    /// <summary>
    /// Draws everything that is switched on, as it is now: also what waits for the next update, and not what waits to leave. Contacts are
    /// those of the last update.
    /// </summary>
    public void Draw()
    {
        CollectTouching();
        if (EnableFluidView)
        {
            for (int i = 0; i < _simulator.ControllerList.Count; i++)
            {
                DrawFluid(_simulator.ControllerList[i]);
            }
        }

        foreach (Geom geom in _simulator.ListPresent())
        {
            DrawGeom(geom);
        }

        if (EnableCoordinateAxisView)
        {
            _bodies.Clear();
            _simulator.ListPresent(_bodies);
            _bodies.ForEach(DrawAxes);
        }

        if (EnableJointView)
        {
            _joints.Clear();
            _simulator.ListPresent(_joints);
            _joints.ForEach(DrawJoint);
        }

        if (EnableSpringView)
        {
            _springs.Clear();
            _simulator.ListPresent(_springs);
            _springs.ForEach(DrawSpring);
        }

        if (EnableContactView)
        {
            DrawContacts();
        }
    }

    private void CollectTouching()
    {
        _touching.Clear();
        foreach (Arbiter arbiter in _simulator.ArbiterList)
        {
            _touching.Add(arbiter.GeomA.Body);
            _touching.Add(arbiter.GeomB.Body);
        }
    }

    private void DrawContacts()
    {
        float strongest = 0;
        foreach (Arbiter arbiter in _simulator.ArbiterList)
        {
            foreach (Contact contact in arbiter.ContactList)
            {
                strongest = Math.Max(strongest, contact.NormalImpulse);
            }
        }

        foreach (Arbiter arbiter in _simulator.ArbiterList)
        {
            foreach (Contact contact in arbiter.ContactList)
            {
                float share = strongest > 0 ? contact.NormalImpulse / strongest : 0;
                _draw.DrawLine(contact.Position, contact.Position + (_markLength * share * contact.Normal), ContactColor);
                _draw.DrawPoint(contact.Position, _pointSize, ContactColor);
            }
        }
    }

    private DebugColor ColorOf(Geom geom)
    {
        Body body = geom.Body;
        if (geom.IsSensor)
        {
            return SensorColor;
        }

        if (!body.Enabled || !body.Awake)
        {
            return SleepingColor;
        }

        if (body.IsKinematic)
        {
            return KinematicColor;
        }

        if (body.IsStatic)
        {
            return StaticColor;
        }

        return _touching.Contains(body) ? TouchingColor : FreeColor;
    }
}
