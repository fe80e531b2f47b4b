using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// A geom's material and filters, and the collider that mirrors them while the geom is in a world. A part of the geom: it is never copied.
/// </summary>
internal struct GeomLink
{
    /// <summary>Whether it is in a state, and since when it has been as it is.</summary>
    public StateMark Mark;

    private World? _world;

    public GeomLink()
    {
    }

    public float Friction { readonly get; private set; }

    public float Restitution { readonly get; private set; }

    public int Group { readonly get; private set; }

    public CollisionCategory Categories { readonly get; private set; } = CollisionCategory.All;

    public CollisionCategory CollidesWith { readonly get; private set; } = CollisionCategory.All;

    public bool CollisionEnabled { readonly get; private set; } = true;

    public bool ResponseEnabled { readonly get; private set; } = true;

    public bool IsSensor { readonly get; private set; }

    public Handle Handle { readonly get; private set; }

    /// <summary>The body whose slot the collider is on; differs from the geom's body between <c>SetBody</c> and the next update.</summary>
    public Body? AttachedBody { readonly get; private set; }

    public readonly bool IsAttached => _world is not null;

    public void CopyFrom(in GeomLink other)
    {
        Mark.Change();
        Friction = other.Friction;
        Restitution = other.Restitution;
        Group = other.Group;
        Categories = other.Categories;
        CollidesWith = other.CollidesWith;
        CollisionEnabled = other.CollisionEnabled;
        ResponseEnabled = other.ResponseEnabled;
        IsSensor = other.IsSensor;
    }

    public void SetMaterial(float friction, float restitution)
    {
        Mark.Change();
        Friction = friction;
        Restitution = restitution;
        if (_world is not null)
        {
            ref ColliderInfo info = ref _world.Collider(Handle);
            info.Friction = friction;
            info.Restitution = restitution;
            _world.NoteChanged(Handle);
        }
    }

    public void SetFilter(Geom geom, int group, CollisionCategory categories, CollisionCategory collidesWith)
    {
        Mark.Change();
        Group = group;
        Categories = categories;
        CollidesWith = collidesWith;
        PushFilter(geom);
    }

    public void SetCollisionEnabled(Geom geom, bool value)
    {
        Mark.Change();
        CollisionEnabled = value;
        PushFilter(geom);
    }

    public void SetResponse(Geom geom, bool responseEnabled, bool isSensor)
    {
        Mark.Change();
        ResponseEnabled = responseEnabled;
        IsSensor = isSensor;
        PushFlags(geom);
    }

    /// <summary>Tells the world which events are wanted, so that a pair without handlers costs nothing.</summary>
    public void PushFlags(Geom geom)
    {
        Mark.Change();
        if (_world is not null)
        {
            _world.Collider(Handle).Flags = Flags(geom);
            _world.NoteChanged(Handle);
        }
    }

    public void Attach(Geom geom, World world)
    {
        Mark.Change();
        Handle = world.CreateCollider(geom.Body.Link.Handle, geom.Form!.Shape, Describe(geom));
        world.Shapes.Order[Handle.Index] = geom.Id;
        if (geom.HasSurface)
        {
            world.Surfaces.Use();
        }

        AttachedBody = geom.Body;
        _world = world;
    }

    /// <summary>What a collider of a geom is made from.</summary>
    public static ColliderDef Describe(Geom geom)
    {
        ref GeomLink link = ref geom.Link;
        return new ColliderDef
        {
            Flags = link.Flags(geom),
            Friction = link.Friction,
            Restitution = link.Restitution,
            Group = link.Group,
            Categories = (uint)link.Categories,
            CollidesWith = (uint)link.CollidesWith,
            Offset = geom.EffectiveOffset,
            RotationOffset = geom.RotationOffset,
        };
    }

    public void Detach()
    {
        Mark.Change();
        World world = _world!;
        _world = null;
        AttachedBody = null;
        world.DestroyCollider(Handle);
        Handle = default;
    }

    private readonly ColliderFlags Flags(Geom geom)
    {
        ColliderFlags flags = ColliderFlags.Alive;
        flags |= CollisionEnabled ? ColliderFlags.CollisionEnabled : ColliderFlags.None;
        flags |= ResponseEnabled && !IsSensor ? ColliderFlags.ResponseEnabled : ColliderFlags.None;
        flags |= geom.OnCollision is not null ? ColliderFlags.WantsContact : ColliderFlags.None;
        flags |= geom.OnSeparation is not null ? ColliderFlags.WantsSeparation : ColliderFlags.None;
        flags |= geom.OneWayDirection != System.Numerics.Vector2.Zero
            ? ColliderFlags.WantsContact | ColliderFlags.WantsSeparation
            : ColliderFlags.None;
        flags |= geom.HasSurface ? ColliderFlags.OwnSurface : ColliderFlags.None;
        return flags | (geom.Simulator is { } simulator ? simulator.Relay.Recorder.WantedOf(IsSensor) : ColliderFlags.None);
    }

    private readonly void PushFilter(Geom geom)
    {
        if (_world is null)
        {
            return;
        }

        ref ColliderInfo info = ref _world.Collider(Handle);
        info.Group = Group;
        info.Categories = (uint)Categories;
        info.CollidesWith = (uint)CollidesWith;
        info.Flags = Flags(geom);
        _world.Pairs.Refilter(Handle);
    }

    /// <summary>Writes, or reads, what later updates read of it.</summary>
    public void Visit(StateStream s)
    {
        if (s.IsReading)
        {
            Mark.Change();
        }

        s.Reference(ref _world);
        Friction = s.Value(Friction);
        Restitution = s.Value(Restitution);
        Group = s.Value(Group);
        Categories = s.Value(Categories);
        CollidesWith = s.Value(CollidesWith);
        CollisionEnabled = s.Value(CollisionEnabled);
        ResponseEnabled = s.Value(ResponseEnabled);
        IsSensor = s.Value(IsSensor);
        Handle = s.Value(Handle);
        AttachedBody = s.Reference(AttachedBody);
    }

    /// <summary>Lets go of a world that is about to be another one.</summary>
    public void TakeOut()
    {
        Mark.Change();
        _world = null;
        AttachedBody = null;
        Handle = default;
    }
}
