using System;
using System.Numerics;
using System.Threading;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>
/// Gives a <see cref="Body"/> a shape that collides: any simple polygon, convex or not, or one of the shapes that
/// <see cref="GeomFactory"/> makes. Several geoms may share a body.
/// </summary>
/// <example>
/// <code>
/// Geom shape = GeomFactory.Instance.CreateRectangleGeom(simulator, body, 2, 1);
/// shape.FrictionCoefficient = 0.5f;
/// shape.RestitutionCoefficient = 0.2f;
/// shape.OnCollision += (mine, other, contacts) =&gt; true;
/// </code>
/// </example>
public partial class Geom : IDisposable, IEquatable<Geom>, IStatePart
{
    private static int s_lastId;

    internal GeomLink Link = new GeomLink();

    private readonly int _id = GetNextId();
    private Body? _body;
    private GeomForm? _form;

    // Null of a rectangle and a circle: their outlines follow from their forms.
    private Vertices? _localVertices;

    // Null of a geom that sits at its body's place, as nearly all do.
    private GeomOffset? _offset;

    // Null until somebody wants one of them.
    private GeomExtras? _extras;
    private float _collisionGridCellSize;

    /// <summary>Makes a geom without body and vertices; give it both before it is added to a simulator.</summary>
    public Geom()
    {
    }

    /// <summary>Makes a polygon geom. The vertices are copied; they may be in any order and are put into the documented one.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="vertices">A simple outline about the body's position; at least three vertices.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The outline has fewer than three vertices, no area, or crosses itself.</exception>
    public Geom(Body body, Vertices vertices, float collisionGridCellSize)
        : this(body, vertices, Vector2.Zero, 0, collisionGridCellSize)
    {
    }

    /// <summary>Makes a polygon geom that sits at an offset from its body.</summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="vertices">A simple outline; at least three vertices.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <param name="collisionGridCellSize">Cell size of the distance grid; 0 or less picks one.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The outline has fewer than three vertices, no area, or crosses itself.</exception>
    public Geom(Body body, Vertices vertices, Vector2 offset, float rotationOffset, float collisionGridCellSize)
        : this()
    {
        CheckBody(body, nameof(body));
        Vertices outline = OutlineRules.Normalised(vertices, nameof(vertices));
        SetOffset(offset, rotationOffset);
        _collisionGridCellSize = CellSize(collisionGridCellSize, outline);
        SetForm(GeomForm.Outline(outline), outline);
        Join(body);
    }

    /// <summary>
    /// Makes a copy of a geom for another body, with the same offset: shape, material and filters are copied, handlers and tag are not.
    /// </summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="geometry">The geom to copy.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public Geom(Body body, Geom geometry)
        : this(body, geometry, Require.NotNull(geometry, nameof(geometry)).Offset, geometry.RotationOffset)
    {
    }

    /// <summary>
    /// Makes a copy of a geom for another body at another offset: shape, material and filters are copied, handlers and tag are not.
    /// </summary>
    /// <param name="body">The body to attach to.</param>
    /// <param name="geometry">The geom to copy.</param>
    /// <param name="offset">Place of the geom in body coordinates.</param>
    /// <param name="rotationOffset">Rotation of the geom against the body, radians.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public Geom(Body body, Geom geometry, Vector2 offset, float rotationOffset)
        : this()
    {
        CheckBody(body, nameof(body));
        Require.NotNull(geometry, nameof(geometry));
        SetOffset(offset, rotationOffset);
        _collisionGridCellSize = geometry._collisionGridCellSize;
        KeptGrid = geometry.KeptGrid;
        _form = geometry._form;
        _localVertices = geometry._localVertices is null ? null : new Vertices(geometry._localVertices);
        Link.CopyFrom(geometry.Link);
        CopySurface(geometry);
        Join(body);
    }

    internal Geom(Body body, GeomForm form, Vertices localVertices, Vector2 offset, float rotationOffset, float cellSize)
        : this()
    {
        CheckBody(body, nameof(body));
        SetOffset(offset, rotationOffset);
        _collisionGridCellSize = CellSize(cellSize, localVertices);
        SetForm(form, localVertices);
        Join(body);
    }

    /// <summary>Handles the contact of two geoms.</summary>
    /// <param name="geometry1">The geom whose handler is called.</param>
    /// <param name="geometry2">The geom that it touches.</param>
    /// <param name="contactList">
    /// The contacts, deepest first. Positions are world coordinates, normals point from <paramref name="geometry1"/> to
    /// <paramref name="geometry2"/> (see <see cref="Farseer201Quirks.NormalsFromOlderGeom"/>); separations are negative where they overlap
    /// and positive where they are about to meet within this step; impulses are 0, for nothing has pushed yet. The list is used again: copy
    /// what you want to keep.
    /// </param>
    /// <returns>False to cancel the response in this step.</returns>
    public delegate bool CollisionEventHandler(Geom geometry1, Geom geometry2, ContactList contactList);

    /// <summary>Handles the separation of two geoms.</summary>
    /// <param name="geometry1">The geom whose handler is called.</param>
    /// <param name="geometry2">The geom that it touched.</param>
    public delegate void SeparationEventHandler(Geom geometry1, Geom geometry2);

    /// <summary>True once <see cref="Dispose()"/> was called.</summary>
    public bool IsDisposed { get; private set => Link.Mark.Set(ref field, value); }

    /// <summary>
    /// The body that carries the geom; null only for a geom made without one, or made since the state that its body went back to
    /// (<see cref="PhysicsSimulator.Restore"/>).
    /// </summary>
    public Body Body => _body!;

    /// <summary>Anything that you want to keep with the geom. Default null.</summary>
    public object? Tag
    {
        get => _extras?.Tag;
        set
        {
            if (ExtrasFor(value) is { } extras)
            {
                extras.Tag = value;
            }
        }
    }

    /// <summary>
    /// A name of your own, which debuggers and reports show. Default null. (Of neighbouring versions of the original.)
    /// </summary>
    public string? Name
    {
        get => _extras?.Name;
        set
        {
            if (ExtrasFor(value) is { } extras)
            {
                extras.Name = value;
            }
        }
    }

    /// <summary>
    /// The outline in geom coordinates, in the documented order. A circle has the number of edges it was made with, although it
    /// collides as a true circle; a rectangle has 16. Do not change the list: use <see cref="SetVertices"/>.
    /// </summary>
    public Vertices LocalVertices => _localVertices ?? ((_extras ??= new GeomExtras()).Outline ??= Outline());

    /// <summary>
    /// Cell size of <see cref="Grid"/>, a length; 0 or less, the default, picks one that fits the outline. Setting it drops the grid, which
    /// is made anew when next asked for.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float CollisionGridCellSize
    {
        get => _collisionGridCellSize;
        set
        {
            _collisionGridCellSize = Link.Mark.Changed(CellSize(value, LocalVertices, nameof(CollisionGridCellSize)));
            KeptGrid = null;
        }
    }

    /// <summary>Precomputed distances around the outline; made when first asked for. Collisions do not need it.</summary>
    public Grid Grid
    {
        get
        {
            if (KeptGrid is null)
            {
                ComputeCollisionGrid();
            }

            return KeptGrid!;
        }
    }

    internal int Id => _id;

    internal GeomForm? Form => _form;

    /// <summary>Takes another form in place of its own if it says the same: a wall of equal bricks then keeps one.</summary>
    /// <returns>The form that the geom has.</returns>
    internal GeomForm? ShareForm(GeomForm? other)
    {
        if (other is not null && _form is not null && _form.IsSameAs(other))
        {
            _form = Link.Mark.Changed(other);
        }

        return _form;
    }

    internal Vector2 Offset => _offset is null ? Vector2.Zero : _offset.Place;

    internal float RotationOffset => _offset is null ? 0 : _offset.Rotation;

    internal PhysicsSimulator? Simulator { get; set => Link.Mark.Set(ref field, value); }

    internal Membership Membership { get; set => Link.Mark.Set(ref field, value); }

    /// <summary>True from the moment an update knows that it will take the geom out until it has.</summary>
    internal bool IsLeaving { get; set => Link.Mark.Set(ref field, value); }

    /// <summary>The next number of the order of creation, which decides which geom of a pair is "A".</summary>
    /// <returns>A number that was not given out before in this process.</returns>
    public static int GetNextId() => Interlocked.Increment(ref s_lastId);

    /// <summary>True while its collider is that of an outline or a body that it no longer has.</summary>
    internal bool WaitsForRemake { get; set => Link.Mark.Set(ref field, value); }

    /// <summary>True while a list of geoms is being made that it is in.</summary>
    [NotState(Why.OfOneStep)]
    internal bool IsListed { get; set; }

    /// <summary>Moves the geom to another body. In a simulator it takes effect at the next update.</summary>
    /// <param name="bodyToSet">The new body.</param>
    /// <exception cref="ArgumentNullException"><paramref name="bodyToSet"/> is null.</exception>
    /// <exception cref="ObjectDisposedException">The geom or the body is disposed.</exception>
    public void SetBody(Body bodyToSet)
    {
        ThrowIfDisposed();
        CheckBody(bodyToSet, nameof(bodyToSet));
        if (ReferenceEquals(bodyToSet, _body))
        {
            return;
        }

        if (Simulator is not null && bodyToSet.Simulator is not null && !ReferenceEquals(Simulator, bodyToSet.Simulator))
        {
            throw new ArgumentException("The body belongs to another simulator than the geom.", nameof(bodyToSet));
        }

        Body? left = _body;
        left?.RemoveGeom(this);
        Join(bodyToSet);
        if (Simulator is not null)
        {
            // From now on the body is taken: another simulator must not get it before this one's next update.
            bodyToSet.Simulator = Simulator;
            Simulator.NoteChanged(this, left);
        }
    }

    /// <summary>Gives the geom another outline; it is a polygon from then on. In a simulator it takes effect at the next update.</summary>
    /// <param name="vertices">A simple outline; at least three vertices. It is copied.</param>
    /// <exception cref="ArgumentNullException"><paramref name="vertices"/> is null.</exception>
    /// <exception cref="ArgumentException">The outline has fewer than three vertices, no area, or crosses itself.</exception>
    public void SetVertices(Vertices vertices)
    {
        ThrowIfDisposed();
        Vertices outline = OutlineRules.Normalised(vertices, nameof(vertices));
        if (_collisionGridCellSize <= 0)
        {
            _collisionGridCellSize = CellSize(0, outline);
        }

        SetForm(GeomForm.Outline(outline), outline);
        Simulator?.NoteChanged(this, _body);
    }

    /// <summary>Makes <see cref="Grid"/> now, so that no later call has to wait for it.</summary>
    public void ComputeCollisionGrid()
    {
        var grid = new Grid();
        grid.ComputeGrid(this, _collisionGridCellSize);
        KeptGrid = grid;
    }

    /// <summary>
    /// Disposes the geom: it takes no further part in collisions and is swept out of the simulator at its next update. Calling it
    /// again does nothing.
    /// </summary>
    public void Dispose()
    {
        Dispose(true);
        GC.SuppressFinalize(this);
    }

    /// <summary>Does the work of <see cref="Dispose()"/>.</summary>
    /// <param name="disposing">True when called by <see cref="Dispose()"/>.</param>
    protected virtual void Dispose(bool disposing)
    {
        if (IsDisposed)
        {
            return;
        }

        IsDisposed = true;
        if (disposing)
        {
            _body?.RemoveGeom(this);
            Simulator?.NoteDisposed(this);
        }
    }

    internal void ThrowIfDisposed()
    {
        if (IsDisposed)
        {
            throw new ObjectDisposedException(nameof(Geom));
        }
    }

    private Grid? KeptGrid
    {
        get => _extras?.Grid;
        set
        {
            if (ExtrasFor(value) is { } extras)
            {
                extras.Grid = value;
            }
        }
    }

    /// <summary>Where a part is to be set that nearly no geom has; that there is none needs no place.</summary>
    private GeomExtras? ExtrasFor(object? value) => Link.Mark.Changed(value is null ? _extras : _extras ??= new GeomExtras());

    private static void CheckBody(Body body, string name)
    {
        Require.NotNull(body, name);
        body.ThrowIfDisposed();
    }

    private static float CellSize(float value, Vertices vertices, string name = "collisionGridCellSize")
    {
        Require.Finite(value, name);
        return value > 0 || vertices.Count == 0 ? value : GeomFactory.Instance.CalculateGridCellSizeFromAABB(vertices);
    }

    private void Join(Body body)
    {
        _body = Link.Mark.Changed(body);
        body.AddGeom(this);
        ForgetFrame();
    }

    private void SetOffset(Vector2 offset, float rotationOffset)
    {
        Require.Place(offset, nameof(offset));
        Require.Finite(rotationOffset, nameof(rotationOffset));
        if (offset != Vector2.Zero || rotationOffset != 0)
        {
            _offset = new GeomOffset(offset, rotationOffset);
        }
    }

    private Vertices Outline() => _form?.OwnOutline() ?? new Vertices();

    private void SetForm(GeomForm form, Vertices localVertices)
    {
        // Made now and not when the simulator takes the geom in: what cannot be made must be refused at the door.
        _ = form.Shape;
        _form = Link.Mark.Changed(form);
        _localVertices = form.Kind is FormKind.Box or FormKind.Circle ? null : localVertices;
        KeptGrid = null;
        _extras?.Segments = null;
        ForgetFrame();
    }
}
